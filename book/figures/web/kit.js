// What all live figures share: the handle, the numbers, and simple drawings of them.
//
// The book's tool puts this file, the program as `WASM` in base64, and the figures into one script. Nothing is fetched, so
// figures are live in a page that was opened as a file, too. Where scripts do not run, the picture of the last tour stays.

const figures = {};

/** Declares a figure; `parts` are described in `Live`. */
function figure(name, parts) {
    figures[name] = parts;
}

/** Three digits, and no exponent where it can be helped. What only rounding tells from 0 is 0. */
function say(x, digits = 3) {
    if (!Number.isFinite(x)) return x > 0 ? "∞" : "unknown";
    if (Math.abs(x) < 1e-12) return "0";
    const rounded = Number(x.toPrecision(digits));
    const plain = rounded === 0 || (Math.abs(rounded) >= 1e-4 && Math.abs(rounded) < 1e6);
    if (!plain) {
        const [mantissa, power] = rounded.toExponential().split("e");
        return `${mantissa} · 10${raised(Number(power))}`;
    }
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(rounded) || 1)));
    return rounded.toFixed(Math.min(decimals, 8)).replace("-", "−");
}

/** A number with two digits of its standard error. Where no sample differs from the others, none is known. */
function withError(x, error) {
    if (!Number.isFinite(error) || error === 0) return `${say(x)} ± unknown`;
    const decimals = Math.max(0, 1 - Math.floor(Math.log10(error)));
    return `${x.toFixed(decimals).replace("-", "−")} ± ${error.toFixed(decimals)}`;
}

function raised(power) {
    return String(power).replace(/./g, (c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]);
}

/** A range of numbers along a line, even or by their logarithms. */
class Scale {
    constructor([low, high], log = false) {
        Object.assign(this, { low, high, log });
    }

    /** The place of a number, 0 at the lower end and 1 at the upper one. */
    place(x) {
        const { low, high, log } = this;
        return log ? Math.log(x / low) / Math.log(high / low) : (x - low) / (high - low);
    }

    /** The number at a place. */
    at(place) {
        const { low, high, log } = this;
        return log ? low * (high / low) ** place : low + (high - low) * place;
    }

    /** So many numbers, evenly along the line. */
    steps(count) {
        return Array.from({ length: count + 1 }, (_, i) => this.at(i / count));
    }

    /** Numbers to write beside the line, and their words. */
    ticks() {
        const { low, high, log } = this;
        if (log) {
            const [first, last] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
            const every = Math.ceil((last - first + 1) / 6);
            const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i);
            return powers
                .filter((power) => (power - last) % every === 0)
                .map((power) => [10 ** power, power >= -2 && power <= 3 ? String(10 ** power) : `10${raised(power)}`]);
        }
        const rough = (high - low) / 5;
        const unit = 10 ** Math.floor(Math.log10(rough));
        const step = this.step ?? [1, 2, 5, 10].map((x) => x * unit).find((x) => x >= rough);
        const found = [];
        for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) {
            found.push([i * step, String(Number((i * step).toFixed(6))).replace("-", "−")]);
        }
        return found;
    }
}

/** A part of the drawing with coordinates of its own. Colours are words that the style sheet knows. */
class Plot {
    constructor([left, top, width, height], x, y) {
        Object.assign(this, { left, top, width, height, x, y });
        this.parts = [];
    }

    px(x) {
        return this.left + this.width * this.x.place(x);
    }

    py(y) {
        return this.top + this.height * (1 - Math.min(1.02, Math.max(-0.02, this.y.place(y))));
    }

    /** The coordinates of a place of the drawing. */
    under([px, py]) {
        return [this.x.at((px - this.left) / this.width), this.y.at(1 - (py - this.top) / this.height)];
    }

    points(points) {
        return points.map(([x, y]) => `${this.px(x).toFixed(1)},${this.py(y).toFixed(1)}`).join(" ");
    }

    line(points, colour, kind = "") {
        this.parts.push(`<polyline class="stroke ${colour} ${kind}" points="${this.points(points)}"/>`);
    }

    area(points, colour) {
        this.parts.push(`<polygon class="area ${colour}" points="${this.points(points)}"/>`);
    }

    dot([x, y], colour, radius = 3.5, kind = "") {
        this.parts.push(
            `<circle class="dot ${colour} ${kind}" cx="${this.px(x).toFixed(1)}" cy="${this.py(y).toFixed(1)}" r="${radius}"/>`,
        );
    }

    /** A number with its error bar, which ends at the edge where the scale does. */
    measured(x, y, error, colour) {
        const ends = [y - error, y + error].map((end) => Math.min(this.y.high, Math.max(this.y.low, end)));
        this.line(ends.map((end) => [x, end]), colour, "bold");
        this.dot([x, y], colour, 4.5);
    }

    text([x, y], words, { anchor = "middle", colour = "ink", dx = 0, dy = 0 } = {}) {
        const at = `x="${(this.px(x) + dx).toFixed(1)}" y="${(this.py(y) + dy + 4).toFixed(1)}"`;
        this.parts.push(`<text class="${colour}" ${at} text-anchor="${anchor}">${words}</text>`);
    }

    title(words) {
        const at = `x="${this.left + this.width / 2}" y="${this.top - 9}"`;
        this.parts.push(`<text class="ink title" ${at} text-anchor="middle">${words}</text>`);
    }

    axes(xLabel, yLabel) {
        const { left, top, width, height } = this;
        this.parts.push(`<rect class="stroke pale" x="${left}" y="${top}" width="${width}" height="${height}"/>`);
        for (const [x, words] of this.x.ticks()) {
            this.line([[x, this.y.low], [x, this.y.high]], "faint");
            this.text([x, this.y.low], words, { colour: "grey", dy: 13 });
        }
        for (const [y, words] of this.y.ticks()) {
            this.line([[this.x.low, y], [this.x.high, y]], "faint");
            this.text([this.x.low, y], words, { anchor: "end", colour: "grey", dx: -6 });
        }
        const middle = top + height / 2;
        this.parts.push(
            `<text class="grey" x="${left + width / 2}" y="${top + height + 34}" text-anchor="middle">${xLabel}</text>`,
            `<text class="grey" transform="translate(${left - 42} ${middle}) rotate(-90)" text-anchor="middle">${yLabel}</text>`,
        );
    }
}

/** The widest drawing, and the least width at which two parts stand beside each other, in pixels. */
const WIDEST = 720;
const TWO_COLUMNS = 560;

/** Room for parts of a figure: beside each other, or below where the page is narrow. */
class View {
    constructor(width, parts) {
        this.width = Math.min(width, WIDEST);
        this.columns = this.width >= TWO_COLUMNS ? parts : 1;
        this.part = (this.width - 24 * (this.columns - 1)) / this.columns;
        this.plots = [];
        this.tall = 0;
        this.below = 0;
    }

    /** The upper left corner of the next part, of a height. */
    corner(height) {
        const column = this.plots.length % this.columns;
        if (column === 0) {
            this.tall = this.below;
        }
        this.below = Math.max(this.below, this.tall + height);
        return [column * (this.part + 24), this.tall];
    }

    /** The height of a part: less on a narrow page, where another may stand below it. */
    height(narrow) {
        return this.width < TWO_COLUMNS ? narrow : 300;
    }

    /** A part true to scale: as large as fits. */
    drawing([left, right], [low, high], title) {
        const scale = Math.min(this.part / (right - left), this.height(210) / (high - low));
        const [width, height] = [scale * (right - left), scale * (high - low)];
        const [x, y] = this.corner(height + 28);
        return this.add([x + (this.part - width) / 2, y + 28, width, height], new Scale([left, right]), new Scale([low, high]), title);
    }

    /** A part with axes. */
    chart(x, y, title) {
        const height = this.height(240);
        const [left, top] = this.corner(height + 28);
        return this.add([left + 62, top + 28, this.part - 76, height - 44], x, y, title);
    }

    add(box, x, y, title) {
        const plot = new Plot(box, x, y);
        plot.title(title);
        this.plots.push(plot);
        return plot;
    }
}

/**
 * A figure that computes. `parts` are:
 *
 * - `label`, `range`, `log`, `steps`, `start`, `words(value)`: the handle;
 * - `random`: whether another run, with another seed, shows something else; `seed`: the first, if not 1;
 * - `columns`: how many parts stand beside each other;
 * - `prepare(numbers, seed)`: what only another run changes;
 * - `draw(view, numbers, value, seed, prepared)`: draws, and returns what to `read` and where the `handle` is, as its plot
 *   and a point;
 * - `drag([x, y])`: the value for a point of that plot.
 */
class Live {
    constructor(place, parts, numbers) {
        Object.assign(this, { place, parts, numbers });
        this.scale = new Scale(parts.range, parts.log);
        const id = `live-${place.dataset.live}`;
        this.stage = document.createElement("div");
        this.stage.className = "live-stage";
        this.stage.innerHTML = `
            <svg role="img" aria-labelledby="${id}-reading"><g></g><circle class="handle" r="7"/></svg>
            <div class="live-handle">
                <label for="${id}">${parts.label}</label>
                <input type="range" id="${id}" min="0" max="${parts.steps}" step="1">
                <output for="${id}"></output>
                ${parts.random ? '<button type="button" class="again">another run</button>' : ""}
                <button type="button" class="reset">reset</button>
            </div>
            <p class="live-reading" id="${id}-reading" role="status"></p>`;
        const find = (what) => this.stage.querySelector(what);
        [this.svg, this.input, this.output] = [find("svg"), find("input"), find("output")];
        [this.group, this.knob, this.reading] = [find("g"), find(".handle"), find(".live-reading")];
        place.prepend(this.stage);
        place.classList.add("is-live");

        this.input.addEventListener("input", () => this.show());
        // Else the book turns its pages by the same keys.
        this.stage.addEventListener("keydown", (event) => event.stopPropagation());
        find(".reset").addEventListener("click", () => this.reset());
        find(".again")?.addEventListener("click", () => this.run(this.seed + 1));
        // A finger on the handle drags it, and not the page.
        this.knob.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
        this.knob.addEventListener("pointerdown", (event) => {
            this.knob.setPointerCapture(event.pointerId);
            event.preventDefault();
        });
        this.knob.addEventListener("pointermove", (event) => {
            if (this.knob.hasPointerCapture(event.pointerId)) this.drag(event);
        });
        new ResizeObserver(() => this.show()).observe(place);
        this.reset();
    }

    value() {
        return this.scale.at(this.input.value / this.parts.steps);
    }

    reset() {
        this.input.value = Math.round(this.scale.place(this.parts.start) * this.parts.steps);
        this.run(this.parts.seed ?? 1);
    }

    run(seed) {
        this.seed = seed;
        this.prepared = this.parts.prepare?.(this.numbers, seed);
        this.show();
    }

    drag(event) {
        const box = this.svg.getBoundingClientRect();
        const at = [event.clientX - box.left, event.clientY - box.top].map((x) => (x * this.view.width) / box.width);
        const place = this.scale.place(this.parts.drag(this.held.under(at)));
        const step = Math.round(place * this.parts.steps);
        // Further than the handle reaches, or no number at all where a logarithm has none: the nearer end.
        this.input.value = Math.min(this.parts.steps, Math.max(0, step || 0));
        this.show();
    }

    show() {
        const width = this.stage.clientWidth;
        // A part of the page that is not shown has no width.
        if (width === 0) return;
        const value = this.value();
        const view = new View(width, this.parts.columns);
        const { read, handle } = this.parts.draw(view, this.numbers, value, this.seed, this.prepared);
        const [plot, [x, y]] = handle;
        Object.assign(this, { view, held: plot });
        this.svg.setAttribute("viewBox", `0 0 ${view.width} ${view.below}`);
        this.svg.style.maxWidth = `${view.width}px`;
        this.group.innerHTML = view.plots.map((part) => part.parts.join("")).join("");
        this.knob.setAttribute("cx", plot.px(x));
        this.knob.setAttribute("cy", plot.py(y));
        this.output.textContent = this.parts.words(value);
        this.input.setAttribute("aria-valuetext", this.parts.words(value));
        this.reading.textContent = read;
    }
}

/** Makes all figures of the page live. */
async function start() {
    const bytes = Uint8Array.from(atob(WASM), (c) => c.charCodeAt(0));
    const { instance } = await WebAssembly.instantiate(bytes);
    const { exports } = instance;
    const list = (name) => (handle, seed = 0) => {
        const length = exports[name](handle, seed);
        return Array.from({ length }, (_, i) => exports.number(i));
    };
    const names = Object.keys(exports).filter((name) => exports[name].length === 2);
    const numbers = Object.fromEntries(names.map((name) => [name, list(name)]));
    for (const place of document.querySelectorAll("figure[data-live]")) {
        new Live(place, figures[place.dataset.live], numbers);
    }
    document.documentElement.classList.add("has-live-figures");
}
