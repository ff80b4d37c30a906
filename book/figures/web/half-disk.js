// Chapter 04: a surface to tilt, under a white sky.

figure("half-disk", {
    label: "tilt",
    range: [0, 90],
    steps: 90,
    start: 30,
    words: (tilt) => `${Math.round(tilt)}°`,
    random: true,
    columns: 2,
    draw(view, numbers, tilt, seed) {
        const read = numbers.half_disk(tilt, seed);
        const [right, rightError, rightExact, wrong, wrongError, wrongExact, below] = read;
        const n = [Math.sin((tilt * Math.PI) / 180), Math.cos((tilt * Math.PI) / 180)];
        const ends = read.slice(7);
        const half = ends.length / 2;
        const panel = (title, rays) => {
            const plot = view.drawing([-1.35, 1.35], [-1.15, 1.35], title);
            const across = (share) => [n[1] * share, -n[0] * share];
            for (let i = 0; i < rays.length; i += 2) {
                const [x, y] = [rays[i], rays[i + 1]];
                const above = x * n[0] + y * n[1] >= 0;
                plot.line([[0, 0], [x, y]], above ? "blue" : "vermillion");
            }
            plot.line([across(-1.3), across(1.3)], "ink", "bold");
            plot.line([[0, 0], n.map((x) => 1.2 * x)], "ink");
            // Beside the normal, where the handle does not hide it.
            plot.text(n.map((x) => 1.08 * x), "n", { colour: "ink halo", dx: -16 * n[1], dy: 16 * n[0] });
            return plot;
        };
        const first = panel("tangent and normal as columns", ends.slice(0, half));
        panel("as rows: the transpose", ends.slice(half));
        return {
            read:
                `The right matrix reads ${withError(right, rightError)} (exactly ${rightExact}). The transpose reads ` +
                `${withError(wrong, wrongError)} (exactly cos² ${Math.round(tilt)}° = ${say(wrongExact)}), ` +
                `and ${Math.round(100 * below)} % of its rays go below the surface.`,
            handle: [first, n.map((x) => 1.2 * x)],
        };
    },
    drag: ([x, y]) => (Math.atan2(x, y) * 180) / Math.PI,
});
