// Chapter 07: a path to follow, segment by segment.

figure("path", {
    label: "segment",
    range: [1, 6],
    steps: 5,
    start: 4,
    words: (segment) => String(Math.round(segment)),
    random: true,
    // A path that takes its time.
    seed: 19,
    columns: 2,
    draw(view, numbers, value, seed) {
        const segment = Math.round(value);
        const read = numbers.path(segment, seed);
        const [soFar, all, mean, error, exact] = read;
        const vertices = Array.from({ length: segment }, (_, i) => read.slice(5 + 6 * i, 11 + 6 * i));
        const lobe = read.slice(5 + 6 * segment);
        const room = view.drawing([-0.06, 1.06], [-0.06, 1.06], "the room, its ceiling shining");
        room.line([[0, 1], [0, 0], [1, 0], [1, 1]], "ink", "bold");
        room.line([[0, 1], [1, 1]], "orange", "bold");
        const [, , x, y] = vertices[segment - 1];
        // A lobe whose longest ray, straight up, is 0.5 per radian.
        const around = [];
        for (let i = 0; i < lobe.length; i += 2) around.push([x + 0.3 * lobe[i], y + 0.3 * lobe[i + 1]]);
        room.area(around, "green");
        for (const [i, [fromX, fromY, toX, toY, emitted, beta]] of vertices.entries()) {
            room.line([[fromX, fromY], [toX, toY]], i === 0 ? "ink" : "blue", "bold");
            room.dot([toX, toY], emitted > 0 ? "orange" : "blue");
            // Not in the middle, where segments cross.
            const at = [0.6 * fromX + 0.4 * toX, 0.6 * fromY + 0.4 * toY];
            room.text(at, `β = ${say(beta)}`, { colour: "ink halo" });
        }
        room.dot(vertices[0].slice(0, 2), "ink", 4.5, "hollow");

        const chart = view.chart(new Scale([0.5, 6.5]), new Scale([0, 1.05]), "what each segment brings");
        chart.x.step = 1;
        chart.axes("segment", "share β, and light of it");
        for (const [i, vertex] of vertices.entries()) {
            const [emitted, beta] = vertex.slice(4);
            const column = (height) => [
                [i + 0.7, 0],
                [i + 0.7, height],
                [i + 1.3, height],
                [i + 1.3, 0],
            ];
            chart.area(column(beta * emitted), "orange");
            chart.line(column(beta), "blue");
        }
        const [emitted, beta] = vertices[segment - 1].slice(4);
        const where = emitted > 0 ? `on the ceiling, which shines: it brings β × ${emitted} = ${say(beta * emitted)}` : "on a dark wall";
        return {
            read:
                `Segment ${segment} ends ${where}. So far the path brings ${say(soFar)}, all of it ${say(all)}. The mean of 1000 ` +
                `paths is ${withError(mean, error)}, the truth ${say(exact, 4)}.`,
            handle: [chart, [segment, beta]],
        };
    },
    drag: ([segment]) => segment,
});
