// Chapter 03: as many darts as one likes, and the error bar that they earn.

figure("darts", {
    label: "darts N",
    range: [32, 131072],
    log: true,
    steps: 48,
    start: 1024,
    words: (darts) => String(Math.round(darts)),
    random: true,
    columns: 2,
    prepare(numbers, seed) {
        const many = new Scale(this.range, true).steps(48);
        return many.map((darts) => [darts, ...numbers.darts(darts, seed)]);
    },
    draw(view, numbers, darts, seed, run) {
        const [mean, error] = numbers.darts(darts, seed);
        const thrown = numbers.board(darts, seed);
        const board = view.drawing([-0.04, 1.04], [-0.04, 1.04], `the first ${thrown.length / 3} darts`);
        board.line([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], "grey");
        const quarter = new Scale([0, Math.PI / 2]).steps(48);
        board.line(quarter.map((angle) => [Math.cos(angle), Math.sin(angle)]), "ink", "bold");
        for (let i = 0; i < thrown.length; i += 3) {
            board.dot(thrown.slice(i, i + 2), thrown[i + 2] > 0 ? "blue" : "vermillion", 2);
        }
        const chart = view.chart(new Scale(this.range, true), new Scale([2.6, 3.7]), "one run, ± two standard errors");
        chart.y.step = 0.2;
        chart.axes("darts", "estimate of π");
        const above = run.map(([n, pi, e]) => [n, pi + 2 * e]);
        const below = run.map(([n, pi, e]) => [n, pi - 2 * e]);
        chart.area([...above, ...below.reverse()], "blue");
        chart.line(run.map(([n, pi]) => [n, pi]), "blue", "bold");
        chart.line(this.range.map((n) => [n, Math.PI]), "ink", "dashed");
        chart.measured(darts, mean, error, "vermillion");
        const away = Math.abs(mean - Math.PI) / error;
        return {
            read:
                `${Math.round(darts)} darts read ${withError(mean, error)}. The truth lies ${say(away, 2)} standard errors away. ` +
                `Four times as many would have half the error bar.`,
            handle: [chart, [darts, mean]],
        };
    },
    drag: ([darts]) => darts,
});
