// Chapter 10: a probability to survive, on both sides of the wall.

figure("roulette", {
    label: "survival q",
    range: [0.4, 0.98],
    steps: 58,
    start: 0.9,
    words: (q) => q.toFixed(2),
    random: true,
    columns: 1,
    prepare(numbers) {
        const wall = numbers.roulette_law(0.9)[3];
        // Closer together near the wall, where the curve is steep.
        const places = new Scale([0.03, 1]).steps(80).map((t) => wall + (this.range[1] - wall) * t ** 2);
        return { wall, curve: places.map((q) => [q, numbers.roulette_law(q)[1]]).filter(([, v]) => v < 1e4) };
    },
    draw(view, numbers, q, seed, { wall, curve }) {
        const [mean, variance, segments, , settles] = numbers.roulette_law(q);
        const [read, error, ...runs] = numbers.roulette(q, seed);
        const chart = view.chart(new Scale(this.range), new Scale([0.1, 1e4], true), "the price of stopping early");
        chart.axes("probability q to survive a surface", "variance of a path");
        chart.area([[0.4, 0.1], [0.4, 1e4], [wall, 1e4], [wall, 0.1]], "vermillion");
        chart.line([[wall, 0.1], [wall, 1e4]], "vermillion", "dashed");
        chart.text([(0.4 + wall) / 2, 3500], "infinite variance", { colour: "vermillion" });
        chart.line(curve, "blue", "bold");
        for (const claimed of runs) chart.dot([q, claimed], "ink", 3.5, "hollow");
        const claim = !Number.isFinite(variance)
            ? "The variance is infinite, so this error bar means nothing."
            : settles
              ? `The variance is ${say(variance)}, and the runs agree on it.`
              : `The variance is ${say(variance)}, and most runs claim less.`;
        return {
            read:
                `Paths have ${say(segments)} segments on average. 4800 of them read ${withError(read, error)}; the truth is ` +
                `${say(mean, 2)}. ${claim}`,
            handle: [chart, [q, Math.min(variance, 1e4)]],
        };
    },
    drag: ([q]) => q,
});
