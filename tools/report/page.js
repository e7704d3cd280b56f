// The page of an optimisation: replays its flips on the halfedge table, as kernel/flip.hpp does them,
// and shows start and present surface, plots and tables. The data are those of report_page.cpp.
'use strict';
(() => {

const data = JSON.parse(document.getElementById('data').textContent);
const element = (id) => document.getElementById(id);
const number = (n) => n.toLocaleString('en-US');
const flipsInWords = (n) => number(n) + (n === 1 ? ' flip' : ' flips');
const shapeNames = ['convex', 'concave', 'flat', 'folded', 'degenerate'];
const concave = 1;
const lastFlipped = shapeNames.length; // drawn like one shape more

function decoded(base64, Kind) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return new Kind(bytes.buffer);
}

// ---- the surface ----

class Table {
    constructor(frame) {
        this.next = decoded(frame.next, Int32Array);
        this.origin = decoded(frame.origin, Int32Array);
        this.shapes = decoded(frame.shapes, Uint8Array);
        this.counts = shapeNames.map(() => 0);
        for (const shape of this.shapes) ++this.counts[shape];
    }
    // Edge ab of faces abc and bad becomes dc; `turned` becomes the side dc.
    turn(edge, turned) {
        const { next, origin } = this;
        const h = 2 * edge, t = h ^ 1;
        const h1 = next[h], t1 = next[t], h2 = next[h1], t2 = next[t1];
        const c = origin[h2], d = origin[t2];
        const dc = turned, cd = turned ^ 1;
        next[dc] = h2; origin[dc] = d;
        next[cd] = t2; origin[cd] = c;
        next[h2] = t1; next[t1] = dc;
        next[t2] = h1; next[h1] = cd;
    }
    // The edge and the four around it, in the order in which their shapes are kept: before a flip...
    around(edge) {
        const { next } = this;
        const h1 = next[2 * edge], t1 = next[2 * edge + 1];
        return [edge, h1 >> 1, next[h1] >> 1, t1 >> 1, next[t1] >> 1];
    }
    // ... and after it.
    aroundFlipped(edge) {
        const { next } = this;
        const h2 = next[2 * edge], t2 = next[2 * edge + 1];
        return [edge, next[t2] >> 1, h2 >> 1, next[h2] >> 1, t2 >> 1];
    }
    // Five digits to the base of five.
    setShapes(edges, packed) {
        for (const edge of edges) {
            --this.counts[this.shapes[edge]];
            this.shapes[edge] = packed % 5;
            ++this.counts[packed % 5];
            packed = Math.floor(packed / 5);
        }
    }
    packedShapes(edges) {
        return edges.reduceRight((packed, edge) => 5 * packed + this.shapes[edge], 0);
    }
    checksum() {
        let hash = 2166136261;
        for (let h = 0; h < this.next.length; ++h) {
            hash = Math.imul(hash ^ this.next[h], 16777619);
            hash = Math.imul(hash ^ this.origin[h], 16777619);
        }
        return (hash >>> 0).toString(16).padStart(8, '0');
    }
}

// Positions 0 .. last, one a flip. Shapes before each flip are learnt when it is first done.
class Steps {
    constructor() {
        this.flips = decoded(data.steps, Int32Array);
        this.after = decoded(data.stepShapes, Uint16Array);
        this.before = new Uint16Array(this.after.length);
        this.table = new Table(data.frames[0]);
        this.last = this.flips.length;
        this.position = 0;
    }
    flipsAt(position) { return position; }
    positionAt(flips) { return flips; }
    lastEdge() { return this.position > 0 ? this.flips[this.position - 1] : -1; }
    goTo(position) {
        const { table, flips } = this;
        while (this.position < position) {
            const i = this.position++;
            const edges = table.around(flips[i]);
            this.before[i] = table.packedShapes(edges);
            table.turn(flips[i], 2 * flips[i]);
            table.setShapes(edges, this.after[i]);
        }
        while (this.position > position) {
            const i = --this.position;
            const edges = table.aroundFlipped(flips[i]);
            table.turn(flips[i], 2 * flips[i] + 1);
            table.setShapes(edges, this.before[i]);
        }
    }
}

// Positions 0 .. last, one a surface that is kept whole.
class Frames {
    constructor() {
        this.last = data.frames.length - 1;
        this.goTo(0);
    }
    flipsAt(position) { return data.frames[position].at; }
    positionAt(flips) {
        const after = data.frames.findIndex((frame) => frame.at > flips);
        return after < 0 ? this.last : after - 1;
    }
    lastEdge() { return -1; }
    goTo(position) {
        if (position !== this.position) this.table = new Table(data.frames[position]);
        this.position = position;
    }
}

const isDrawn = data.frames.length > 0;
const sequence = !isDrawn ? null : data.steps !== undefined ? new Steps() : new Frames();

// ---- once over the whole sequence: is the end the program's, and what do edges do on the way ----

const concaveEdges = [];
if (sequence) {
    const samples = Math.min(sequence.last, 1000);
    for (let i = 0; i <= samples; ++i) {
        sequence.goTo(samples === 0 ? 0 : Math.round(sequence.last * i / samples));
        concaveEdges.push({ x: sequence.flipsAt(sequence.position), y: sequence.table.counts[concave] });
    }
    const equal = sequence.table.checksum() === data.checksum;
    document.body.dataset.replay = equal ? 'equal' : 'different';
    element('replayed').textContent = equal
        ? `Replayed in this page, the flips lead to the very table the program ended with (checksum ${data.checksum}).`
        : 'Replayed in this page, the flips lead to another table than the program ended with: this file is damaged.';
    if (!equal) complain(element('replayed').textContent);
}

function complain(text) {
    element('problem').textContent = text;
    element('problem').hidden = false;
}

// ---- tables ----

function addRow(parent, cells, first = 'th') {
    const row = parent.insertRow();
    cells.forEach((cell, i) => {
        const node = document.createElement(i === 0 ? first : parent.tagName === 'THEAD' ? 'th' : 'td');
        node.append(...(Array.isArray(cell) ? cell : [cell]));
        row.append(node);
    });
    return row;
}

const presentCounts = [];
{
    element('summary').textContent = [`${number(data.vertices)} vertices`, `${number(data.edges)} edges`,
        `${number(data.faces)} faces`, `genus ${data.genus}`, flipsInWords(data.flips)].join(' · ');
    const facts = element('facts').createTBody();
    for (const [name, value] of data.facts) addRow(facts, [name, value]);

    addRow(element('edges').createTHead(), ['shape', 'start', ...(sequence ? ['shown'] : []), 'end']);
    const body = element('edges').createTBody();
    shapeNames.forEach((name, shape) => {
        const swatch = document.createElement('span');
        swatch.className = 'swatch';
        swatch.style.background = `var(--${name})`;
        const present = document.createElement('span');
        presentCounts.push(present);
        addRow(body, [[swatch, name], number(data.shapesBefore[shape]), ...(sequence ? [[present]] : []),
            number(data.shapesAfter[shape])]);
    });
}

// ---- plots ----

const charts = [];
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const shownFlips = () => sequence ? sequence.flipsAt(sequence.position) : data.flips;

// A vertical line at the flips that are shown.
const marker = {
    id: 'marker',
    afterDatasetsDraw(chart) {
        const x = chart.scales.x.getPixelForValue(shownFlips());
        const { ctx, chartArea } = chart;
        ctx.save();
        ctx.strokeStyle = css('soft');
        ctx.setLineDash([4, 3]);
        ctx.beginPath();
        ctx.moveTo(x, chartArea.top);
        ctx.lineTo(x, chartArea.bottom);
        ctx.stroke();
        ctx.restore();
    },
};

function addPlot(name, points, colour) {
    const box = document.createElement('div');
    const heading = document.createElement('h2');
    const frame = document.createElement('div');
    const canvas = document.createElement('canvas');
    box.className = 'plot';
    heading.textContent = name;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', `${name} against flips, from ${points[0].y} to ${points[points.length - 1].y}`);
    frame.append(canvas);
    box.append(heading, frame);
    element('plots').append(box);
    const chart = new Chart(canvas, {
        type: 'line',
        data: { datasets: [{ label: name, data: points, borderWidth: 2, pointRadius: points.length < 30 ? 2 : 0 }] },
        plugins: [marker],
        options: {
            animation: false, parsing: false, maintainAspectRatio: false,
            interaction: { mode: 'nearest', axis: 'x', intersect: false },
            plugins: { legend: { display: false } },
            scales: {
                x: { type: 'linear', min: 0, max: Math.max(data.flips, 1), title: { display: true, text: 'flips' },
                     ticks: { precision: 0, maxRotation: 0 } },
                y: { type: 'linear' },
            },
            onClick(event) {
                if (sequence) show(sequence.positionAt(Math.round(chart.scales.x.getValueForPixel(event.x))));
            },
        },
    });
    chart.colourName = colour;
    chart.hasLogarithms = points.every((point) => point.y > 0);
    charts.push(chart);
}

function colourPlots() {
    for (const chart of charts) {
        const set = chart.data.datasets[0];
        set.borderColor = set.backgroundColor = css(chart.colourName);
        for (const axis of Object.values(chart.options.scales)) {
            axis.ticks.color = css('soft');
            axis.grid.color = css('line');
            axis.grid.borderColor = css('line');
            axis.title.color = css('soft');
        }
        chart.update('none');
    }
}

for (const series of data.series) {
    const points = series.flips.map((x, i) => ({ x, y: series.values[i] })).filter((point) => point.y !== null);
    if (points.length > 0) addPlot(series.name, points, 'accent');
}
if (concaveEdges.length > 0) addPlot('concave edges', concaveEdges, 'concave');
element('log-option').hidden = !charts.some((chart) => chart.hasLogarithms);
element('log-scale').addEventListener('change', () => {
    for (const chart of charts) {
        if (chart.hasLogarithms) {
            chart.options.scales.y.type = element('log-scale').checked ? 'logarithmic' : 'linear';
        }
    }
    colourPlots();
});

// ---- space ----

// Lines as wide as asked for: a quadrilateral an edge, turned to the screen.
const edgeVertexShader = `
    attribute vec3 from, to;
    attribute float kind;
    uniform vec2 size;
    uniform vec3 colours[6];
    uniform float widths[6];
    varying vec3 colour;
    void main() {
        vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0);
        vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
        vec2 along = (b.xy / b.w - a.xy / a.w) * size;
        vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) : vec2(0.0);
        vec4 place = mix(a, b, position.x);
        place.xy += across * position.y * widths[int(kind + 0.5)] / size * place.w;
        place.z -= 2e-5 * place.w;
        colour = colours[int(kind + 0.5)];
        gl_Position = place;
    }`;
const edgeFragmentShader = `
    varying vec3 colour;
    void main() { gl_FragColor = vec4(colour, 1.0); }`;

class Space {
    constructor(canvas) {
        this.canvas = canvas;
        this.points = decoded(data.points, Float32Array);
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
        this.renderer.setScissorTest(true);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(28, 1, 0.4, 40);
        this.camera.up.set(0, 0, 1);
        this.scene.add(this.camera, new THREE.HemisphereLight(0xffffff, 0x8090a0, 0.75));
        const lamp = new THREE.DirectionalLight(0xffffff, 0.45);
        lamp.position.set(-1, 1.5, 2);
        this.camera.add(lamp);

        const behindEdges = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
        this.outside = new THREE.MeshLambertMaterial({ side: THREE.FrontSide, ...behindEdges });
        this.inside = new THREE.MeshLambertMaterial({ side: THREE.BackSide, ...behindEdges });
        this.edgeMaterial = new THREE.ShaderMaterial({
            vertexShader: edgeVertexShader, fragmentShader: edgeFragmentShader, side: THREE.DoubleSide,
            uniforms: {
                size: { value: new THREE.Vector2() },
                colours: { value: [...shapeNames, 'last'].map(() => new THREE.Color()) },
                widths: { value: [] },
            },
        });
        this.views = [this.newView(), this.newView()];
        this.fill(0, new Table(data.frames[0]), -1);

        this.controls = new THREE.OrbitControls(this.camera, canvas);
        this.controls.enableKeys = false;
        this.controls.enablePan = false;
        this.controls.enableZoom = false; // the wheel scrolls the page until the surface was touched
        this.controls.minDistance = 1.5;
        this.controls.maxDistance = 20;
        this.controls.addEventListener('change', () => this.ask());
        this.controls.addEventListener('start', () => { this.controls.enableZoom = true; });
        canvas.addEventListener('mouseleave', () => { this.controls.enableZoom = false; });
        new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
        this.colour();
        this.turnBack();
        this.resize();
    }

    newView() {
        const faces = new THREE.BufferGeometry();
        const edges = new THREE.InstancedBufferGeometry();
        edges.setAttribute('position', new THREE.BufferAttribute(
            new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
        edges.setIndex([0, 1, 2, 0, 2, 3]);
        const lines = new THREE.Mesh(edges, this.edgeMaterial);
        lines.renderOrder = 1;
        const group = new THREE.Group();
        group.add(new THREE.Mesh(faces, this.inside), new THREE.Mesh(faces, this.outside), lines);
        group.children.forEach((child) => { child.frustumCulled = false; });
        this.scene.add(group);
        const attribute = (geometry, name, Attribute, items, count) => {
            const made = new Attribute(new Float32Array(items * count), items);
            made.setUsage(THREE.DynamicDrawUsage);
            geometry.setAttribute(name, made);
            return made;
        };
        return {
            group, edges,
            position: attribute(faces, 'position', THREE.BufferAttribute, 3, 3 * data.faces),
            normal: attribute(faces, 'normal', THREE.BufferAttribute, 3, 3 * data.faces),
            from: attribute(edges, 'from', THREE.InstancedBufferAttribute, 3, data.edges),
            to: attribute(edges, 'to', THREE.InstancedBufferAttribute, 3, data.edges),
            kind: attribute(edges, 'kind', THREE.InstancedBufferAttribute, 1, data.edges),
        };
    }

    // Makes view `which` show a table.
    fill(which, table, lastEdge) {
        const view = this.views[which];
        const { next, origin, shapes } = table;
        const { points } = this;
        let place = 0;
        for (let h = 0; h < next.length; ++h) {
            const h1 = next[h], h2 = next[h1];
            if (h1 < h || h2 < h) continue;
            const corners = [3 * origin[h], 3 * origin[h1], 3 * origin[h2]];
            const [a, b, c] = corners;
            const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1], uz = points[b + 2] - points[a + 2];
            const vx = points[c] - points[a], vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
            const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
            const scale = 1 / (Math.hypot(x, y, z) || 1);
            for (const corner of corners) {
                for (let i = 0; i < 3; ++i) view.position.array[place + i] = points[corner + i];
                view.normal.array[place] = x * scale;
                view.normal.array[place + 1] = y * scale;
                view.normal.array[place + 2] = z * scale;
                place += 3;
            }
        }
        const all = element('all-edges').checked;
        let count = 0;
        for (let edge = 0; edge < shapes.length; ++edge) {
            const kind = edge === lastEdge ? lastFlipped : shapes[edge];
            if (!all && (shapeNames[kind] === 'convex' || shapeNames[kind] === 'flat')) continue;
            for (let i = 0; i < 3; ++i) {
                view.from.array[3 * count + i] = points[3 * origin[2 * edge] + i];
                view.to.array[3 * count + i] = points[3 * origin[2 * edge + 1] + i];
            }
            view.kind.array[count++] = kind;
        }
        view.edges.maxInstancedCount = count;
        for (const name of ['position', 'normal', 'from', 'to', 'kind']) view[name].needsUpdate = true;
        this.ask();
    }

    colour() {
        this.outside.color.set(css('face'));
        this.inside.color.set(css('inside'));
        const colours = this.edgeMaterial.uniforms.colours.value;
        [...shapeNames, 'last'].forEach((name, i) => colours[i].set(css(name)));
        this.ask();
    }

    seeThrough(yes) {
        for (const material of [this.outside, this.inside]) {
            material.transparent = yes;
            material.depthWrite = !yes;
            material.opacity = yes ? 0.4 : 1;
            material.needsUpdate = true;
        }
        this.ask();
    }

    // Side by side, or on narrow screens one above the other.
    resize() {
        const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
        if (width === 0 || height === 0) return;
        const ratio = Math.min(window.devicePixelRatio || 1, 2);
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.rectangles = window.matchMedia('(max-width: 40rem)').matches
            ? [[0, height / 2, width, height / 2], [0, 0, width, height / 2]]
            : [[0, 0, width / 2, height], [width / 2, 0, width / 2, height]];
        const [, , w, h] = this.rectangles[0];
        this.camera.aspect = w / h;
        this.camera.zoom = Math.min(1, w / h); // all of the surface fits either way
        this.camera.updateProjectionMatrix();
        const uniforms = this.edgeMaterial.uniforms;
        uniforms.size.value.set(w * ratio, h * ratio);
        // On fine meshes thin lines, or there is nothing but lines.
        const spacing = Math.min(w, h) / Math.sqrt(data.edges);
        const thin = ratio * Math.max(0.5, Math.min(1.2, 0.12 * spacing));
        const thick = ratio * Math.max(0.9, Math.min(2.6, 0.26 * spacing));
        uniforms.widths.value = [thin, thick, thin, thick, thick, 1.4 * ratio + thick];
        this.ask();
    }

    turnBack() {
        this.camera.position.set(2.6, -3.4, 1.9).setLength(4.4);
        this.controls.target.set(0, 0, 0);
        this.controls.update();
        this.ask();
    }

    ask() {
        if (this.asked) return;
        this.asked = true;
        requestAnimationFrame(() => { this.asked = false; this.render(); });
    }

    render() {
        this.rectangles.forEach((rectangle, i) => {
            this.views.forEach((view, j) => { view.group.visible = i === j; });
            this.renderer.setViewport(...rectangle);
            this.renderer.setScissor(...rectangle);
            this.renderer.render(this.scene, this.camera);
        });
    }
}

let space = null;
if (isDrawn) {
    const context = document.createElement('canvas').getContext('webgl');
    if (context) {
        if (data.edges > 30000) element('all-edges').checked = false;
        space = new Space(element('space'));
    } else {
        element('no-space').textContent = 'This browser offers no WebGL, so the surface cannot be shown in ' +
            'space. The flips, plots and tables below work without.';
    }
} else {
    element('no-space').textContent = `${number(data.vertices)} vertices are too many to be kept in a page: ` +
        'it holds plots and tables only. tightflip render draws surfaces of any size.';
}
if (!space) {
    element('stage').hidden = true;
    element('no-space').hidden = false;
    for (const id of ['all-edges', 'see-through']) element(id).parentElement.hidden = true;
    for (const id of ['reset', 'turning']) element(id).hidden = true;
}

// ---- the player ----

let playing = null;

function show(position) {
    const slider = element('slider');
    sequence.goTo(Math.max(0, Math.min(sequence.last, position)));
    slider.value = sequence.position;
    const flips = shownFlips();
    slider.setAttribute('aria-valuetext', `${flipsInWords(flips)} of ${number(data.flips)}`);
    element('position').textContent = `${number(flips)} / ${flipsInWords(data.flips)}`;
    element('label-now').textContent = `after ${flipsInWords(flips)}`;
    presentCounts.forEach((span, shape) => { span.textContent = number(sequence.table.counts[shape]); });
    if (space) space.fill(1, sequence.table, sequence.lastEdge());
    for (const chart of charts) chart.draw();
    document.body.dataset.flips = flips;
}

function stop() {
    cancelAnimationFrame(playing);
    playing = null;
    element('play').textContent = '▶';
    element('play').setAttribute('aria-label', 'Play');
}

// All of it in 3 to 15 seconds.
function play() {
    const seconds = Math.max(3, Math.min(15, sequence.last * 0.3));
    const from = sequence.position < sequence.last ? sequence.position : 0;
    let began = null;
    const tick = (now) => {
        began ??= now;
        const position = from + Math.floor((now - began) / 1000 / seconds * sequence.last);
        if (position !== sequence.position) show(position);
        if (position < sequence.last) playing = requestAnimationFrame(tick);
        else stop();
    };
    element('play').textContent = '❚❚';
    element('play').setAttribute('aria-label', 'Pause');
    playing = requestAnimationFrame(tick);
}

function steer(position) {
    if (playing !== null) stop();
    show(position);
}

function onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const focused = event.target;
    const step = event.shiftKey ? 10 : 1;
    const moves = {
        ArrowLeft: () => steer(sequence.position - step),
        ArrowRight: () => steer(sequence.position + step),
        Home: () => steer(0),
        End: () => steer(sequence.last),
        ' ': () => element('play').click(),
    };
    const move = moves[event.key];
    if (!move || (event.key === ' ' && (focused.tagName === 'BUTTON' || focused.type === 'checkbox'))) return;
    event.preventDefault();
    move();
}

function followHash() {
    const wanted = /^#flip=(\d+)$/.exec(location.hash);
    if (wanted) steer(sequence.positionAt(Math.min(Number(wanted[1]), data.flips)));
}

colourPlots();
window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    colourPlots();
    if (space) space.colour();
});
if (!sequence) {
    element('player').hidden = true;
    document.querySelector('#views .options').hidden = true;
} else {
    element('slider').max = sequence.last;
    element('slider').addEventListener('input', () => steer(Number(element('slider').value)));
    element('play').addEventListener('click', () => playing === null ? play() : stop());
    element('play').disabled = sequence.last === 0;
    element('reset').addEventListener('click', () => space.turnBack());
    element('see-through').addEventListener('change', (event) => space.seeThrough(event.target.checked));
    element('all-edges').addEventListener('change', () => {
        space.fill(0, new Table(data.frames[0]), -1);
        show(sequence.position);
    });
    if (sequence instanceof Frames) {
        element('thinned').textContent = `${flipsInWords(data.flips)} are too many to be kept one by one: the ` +
            `slider goes over ${data.frames.length} surfaces, from the first to the last.`;
        element('thinned').hidden = false;
    }
    document.addEventListener('keydown', onKey);
    window.addEventListener('hashchange', followHash);
    show(sequence.last);
    followHash();
}

// For scripts: what is shown.
window.tightflipReport = { data, sequence, space, charts, show };

})();
