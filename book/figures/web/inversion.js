// Chapter 05: a number to move along a distribution function.

figure("inversion", {
    label: "u",
    range: [0, 1],
    steps: 100,
    start: 0.3,
    words: (u) => u.toFixed(2),
    columns: 2,
    prepare(numbers) {
        const inverted = (u) => numbers.inversion(u)[0];
        return {
            curve: new Scale([0, 1]).steps(100).map((u) => [inverted(u), u]),
            twelve: Array.from({ length: 12 }, (_, i) => (i + 0.5) / 12).map((u) => [inverted(u), u]),
        };
    },
    draw(view, numbers, u, _, { curve, twelve }) {
        const [angle, density, , left, , from, right, , to] = numbers.inversion(u);
        const degrees = (x) => (x * 180) / Math.PI;
        const x = new Scale([-90, 90]);
        x.step = 45;
        const chart = view.chart(x, new Scale([0, 1]), "from u to an angle");
        chart.axes("angle θ from the normal, degrees", "u");
        const [l, r, a] = [left, right, angle].map(degrees);
        chart.area([[-90, from], [l, from], [r, to], [-90, to]], "orange");
        chart.area([[l, 0], [l, from], [r, to], [r, 0]], "orange");
        for (const [theta, v] of twelve) {
            chart.line([[-90, v], [degrees(theta), v], [degrees(theta), 0]], "pale", "dashed");
        }
        chart.line(curve.map(([theta, v]) => [degrees(theta), v]), "blue", "bold");
        chart.line([[-90, u], [a, u], [a, 0]], "vermillion", "bold");

        const plot = view.drawing([-1.15, 1.15], [-0.1, 1.15], "the directions");
        const on = (theta, radius = 1) => [radius * Math.sin(theta), radius * Math.cos(theta)];
        const arc = (low, high) => new Scale([low, high]).steps(48).map((theta) => on(theta));
        plot.area([[0, 0], ...arc(left, right)], "orange");
        plot.line(arc(-Math.PI / 2, Math.PI / 2), "grey");
        plot.line([[-1.1, 0], [1.1, 0]], "ink", "bold");
        for (const [theta] of twelve) {
            plot.line([[0, 0], on(theta)], "pale");
            plot.dot(on(theta), "grey", 2.5);
        }
        plot.line([[0, 0], on(angle)], "vermillion", "bold");
        plot.dot(on(angle), "vermillion");
        return {
            read:
                `u = ${u.toFixed(2)} goes to θ = ${say(a)}°, where the density is ${say(density)} per radian. The numbers from ` +
                `${from.toFixed(2)} to ${to.toFixed(2)} fill ${say(r - l)}° of angle.`,
            handle: [chart, [a, u]],
        };
    },
    drag: ([, u]) => u,
});
