// Chapter 16: a window to widen below a lamp.

figure("window", {
    label: "radius",
    range: [1 / 64, 1],
    log: true,
    steps: 60,
    start: 0.25,
    words: (radius) => `${say(radius)} m`,
    random: true,
    columns: 2,
    prepare(numbers) {
        this.curves ??= new Scale(this.range, true).steps(60).map((radius) => {
            const [mean, variance] = numbers.window_law(radius);
            return [radius, (mean - 1) ** 2, variance];
        });
        return this.curves;
    },
    draw(view, numbers, radius, seed, curves) {
        const [mean, variance] = numbers.window_law(radius);
        const [read, error, squared, squaredError, ...photons] = numbers.window(radius, seed);
        const plot = view.drawing([-1.6, 1.6], [-0.2, 1.15], "photons of the first walks");
        for (const x of photons) {
            if (Math.abs(x) < radius) plot.line([[0, 1], [x, 0]], "orange");
        }
        plot.line([[-1.6, 0], [1.6, 0]], "ink", "bold");
        for (const x of photons) {
            if (Math.abs(x) < 1.6) plot.dot([x, 0], Math.abs(x) < radius ? "vermillion" : "grey", 2.5);
        }
        plot.line([[-radius, -0.08], [radius, -0.08]], "vermillion", "thick");
        plot.dot([0, 1], "orange", 6);
        plot.text([0, -0.17], "P");

        const chart = view.chart(new Scale(this.range, true), new Scale([1e-5, 1], true), "squared error of 2000 walks");
        chart.axes("radius of the window, m", "squared error");
        const curve = (of) => curves.map((row) => [row[0], of(row)]).filter(([, y]) => y >= 1e-5);
        chart.line(curve((row) => row[1]), "green", "dashed");
        chart.line(curve((row) => row[2]), "blue", "dashed");
        chart.line(curve((row) => row[1] + row[2]), "ink", "bold");
        chart.text([0.02, 0.3], "variance", { anchor: "start", colour: "blue halo" });
        chart.text([0.95, 0.3], "bias²", { anchor: "end", colour: "green halo" });
        chart.measured(radius, squared, squaredError, "vermillion");
        const bias = (mean - 1) ** 2;
        return {
            read:
                `The window reads ${withError(read, error)}; the truth is 1. Its squared error is bias² + variance = ` +
                `${say(bias, 2)} + ${say(variance, 2)} = ${say(bias + variance, 2)}; measured in 8 runs, ` +
                `${withError(squared, squaredError)}.`,
            handle: [plot, [radius, -0.08]],
        };
    },
    drag: ([x]) => Math.abs(x),
});
