// Chapter 11: a lamp to stretch, and three ways to find it.

figure("lamp", {
    label: "half angle",
    range: [0.01, 1.5],
    log: true,
    steps: 100,
    start: 0.5,
    words: (angle) => `${say(angle, 2)} rad`,
    random: true,
    columns: 2,
    prepare(numbers, seed) {
        // The curves are the same in every run.
        this.curves ??= new Scale(this.range, true).steps(32).map((angle) => [angle, numbers.lamp_law(angle)]);
        return this.curves;
    },
    draw(view, numbers, angle, seed, curves) {
        const law = numbers.lamp_law(angle);
        const read = numbers.lamp(angle, seed);
        const ways = Array.from({ length: 4 }, (_, i) => read.slice(3 * i, 3 * i + 3));
        const [chance, aiming, both] = ways.map(([mean, error]) => withError(mean, error));
        const angles = read.slice(12);
        const half = angles.length / 2;
        const on = (theta, radius) => [radius * Math.sin(theta), radius * Math.cos(theta)];
        const plot = view.drawing([-1.5, 1.5], [-0.1, 1.3], "directions, and where the lamp is");
        const seen = Math.min(Math.tan(angle), 1.48);
        const arc = (radius) => new Scale([-angle, angle]).steps(32).map((theta) => on(theta, radius));
        plot.area([[0, 0], ...arc(1.15)], "orange");
        plot.line([[-seen, 1], [seen, 1]], "orange", "thick");
        plot.line([[-1.5, 0], [1.5, 0]], "ink", "bold");
        for (const [i, theta] of angles.entries()) {
            const found = Math.abs(theta) <= angle;
            const [radius, colour] = i < half ? [0.6, "blue"] : [0.8, "vermillion"];
            plot.dot(on(theta, radius), colour, 3, found ? "" : "hollow");
        }
        plot.text([-1.48, 0.13], "chance", { anchor: "start", colour: "blue" });
        plot.text([-1.48, 0.29], "aiming", { anchor: "start", colour: "vermillion" });

        const x = new Scale(this.range, true);
        const chart = view.chart(x, new Scale([1e-8, 1e3], true), "what one sample costs");
        chart.axes("half angle, radians", "variance / squared mean");
        const relative = (law, i) => law[i + 1] / law[0] ** 2;
        const lines = [
            ["chance", "blue", 8, -8],
            ["aiming", "vermillion", -54, -4],
            ["balance", "green", 8, -8],
            ["power", "purple", 8, 12],
            ["bound", "grey", 8, -8],
            ["oracle", "grey", 10, 8],
        ];
        for (const [i, [name, colour, dx, dy]] of lines.entries()) {
            const shown = curves.filter(([, law]) => relative(law, i) >= 1e-8);
            chart.line(shown.map(([a, law]) => [a, relative(law, i)]), colour, i < 4 ? "bold" : "dashed");
            const [a, first] = shown[{ aiming: 7, oracle: 12 }[name] ?? 0];
            chart.text([a, relative(first, i)], name, { anchor: "start", colour: `${colour} halo`, dx, dy });
            // A variance of none, where no sample met the lamp, lies at the lower edge.
            if (i < 4) chart.dot([angle, Math.max(1e-8, ways[i][2] / law[0] ** 2)], colour, 4.5);
        }
        return {
            read:
                `The floor sends out sin a = ${say(law[0])}. 400 samples read ${chance} by chance, ${aiming} by aiming, and ${both} by ` +
                "both with the balance heuristic.",
            handle: [plot, on(angle, 1.15)],
        };
    },
    drag: ([x, y]) => Math.atan2(Math.abs(x), y),
});
