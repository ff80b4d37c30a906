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
        this.curves ??= [0.5, 0.8, 0.9].map((albedo, i) => {
            const wall = albedo ** 2;
            const first = Math.max(wall, this.range[0]);
            // Closer together near the wall, where the curve is steep.
            const places = new Scale([0.01, 1]).steps(120).map((t) => first + (this.range[1] - first) * t ** 2);
            const prices = places.map((q) => [q, numbers.roulette_law(q)[5 + i]]);
            return { albedo, wall, curve: prices.filter(([, price]) => price < 1000) };
        });
        return this.curves;
    },
    draw(view, numbers, q, seed, curves) {
        const [mean, variance, segments, , settles, , price] = numbers.roulette_law(q);
        const [read, error, ...runs] = numbers.roulette(q, seed);
        const [low, high] = [0.1, 1000];
        const chart = view.chart(new Scale(this.range), new Scale([low, high], true), "what certainty costs");
        chart.axes("probability q to survive a surface", "variance × segments / squared mean");
        const colours = ["blue", "vermillion", "green"];
        for (const [i, { albedo, wall, curve }] of curves.entries()) {
            if (wall > this.range[0]) {
                chart.line([[wall, low], [wall, high]], colours[i], "dashed");
            }
            chart.line(curve, colours[i], "bold");
            const [at, start] = curve[0];
            chart.text([at, start], `albedo ${albedo}`, { anchor: "start", colour: `${colours[i]} halo`, dx: 8, dy: i === 0 ? -8 : 6 });
        }
        // Side by side, so that they show beside the handle where they agree.
        for (const [i, claimed] of runs.entries()) {
            const aside = 0.006 * (i - (runs.length - 1) / 2);
            chart.dot([q + aside, Math.max(low, (claimed * segments) / mean ** 2)], "ink", 3, "hollow");
        }
        const claim = !Number.isFinite(variance)
            ? "The variance is infinite, so this error bar means nothing."
            : settles
              ? `The variance is ${say(variance)}, and the runs agree on it.`
              : `The variance is ${say(variance)}, and most runs claim less.`;
        return {
            read:
                `Albedo 0.8: paths have ${say(segments)} segments on average. 4800 of them read ${withError(read, error)}; the ` +
                `truth is ${say(mean, 2)}. ${claim}`,
            handle: [chart, [q, Math.min(price, high)]],
        };
    },
    drag: ([q]) => q,
});
