// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a study: instructions, practice, a session, and its file. Names of gauge.js are here; STUDY is what
// page.py writes.
"use strict";

const SVG = "http://www.w3.org/2000/svg", GREEN = "#0c0";
const EXAMPLE = STUDY.example, PRACTICE = EXAMPLE.places;
const SETS = sets(STUDY.gauges.length, STUDY.strings);
const $ = id => document.getElementById(id);

function shape(parent, name, attributes) {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    parent.append(made);
    return made;
}

// A gauge on an SVG picture.
class Drawn {
    constructor(svg, color = GREEN) {
        this.group = shape(svg, "g", {fill: "none", stroke: color, "stroke-width": 2.5});
        this.disc = shape(this.group, "ellipse", {cx: 0, cy: 0});
        this.pin = shape(this.group, "line", {x1: 0, y1: 0});
    }

    show([x, y], n, radius) {
        const {rx, ry, turn, pin} = ellipse(n, radius);
        this.group.setAttribute("transform", `translate(${x} ${y})`);
        this.disc.setAttribute("rx", rx);
        this.disc.setAttribute("ry", ry);
        this.disc.setAttribute("transform", `rotate(${turn})`);
        this.pin.setAttribute("x2", pin[0]);
        this.pin.setAttribute("y2", pin[1]);
    }

    color(value) { this.group.setAttribute("stroke", value); }
}

// Calls turned(dx, dy), pixels of the picture from a place, while the pointer is dragged.
function onDrag(svg, place, turned) {
    const at = event => {
        const to = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
        const [x, y] = place();
        turned(to.x - x, to.y - y);
    };
    let held = null;
    svg.onpointerdown = event => {
        if (event.button !== 0) return;
        held = event.pointerId;
        svg.setPointerCapture(held);
        at(event);
        event.preventDefault();
    };
    svg.onpointermove = event => { if (event.pointerId === held) at(event); };
    svg.onpointerup = svg.onpointercancel = () => { held = null; };
}

// Notes of this browser, of this study: who takes part, and how many sessions each picture has.
const notes = {
    key: `fovea ${STUDY.study}`,
    read() {
        try { return JSON.parse(localStorage.getItem(this.key)) || {}; } catch { return this.kept || {}; }
    },
    write(value) {
        this.kept = value;
        try { localStorage.setItem(this.key, JSON.stringify(value)); } catch { /* kept until the page is closed */ }
    },
};

function newParticipant() {
    const digits = crypto.getRandomValues(new Uint32Array(2));
    const told = notes.read(), finished = told.finished || STUDY.stimuli.map(() => 0);
    const stimulus = chosen(finished, Math.random);
    notes.write({finished, stimulus, participant: [...digits].map(d => d.toString(16).padStart(8, "0")).join(""), session: 0});
}

function show(section) {
    for (const each of document.querySelectorAll("section")) each.hidden = each.id !== section;
    document.activeElement?.blur();
}

function addExamples() {
    const [rx, ry] = EXAMPLE.axes, [cx, cy] = EXAMPLE.middle;
    for (const [key, value] of Object.entries({cx, cy, rx, ry})) $("ellipsoid").setAttribute(key, value);
    for (const svg of document.querySelectorAll("svg.example")) {
        svg.setAttribute("viewBox", [0, 0, ...EXAMPLE.size].join(" "));
        shape(svg, "use", {href: "#ellipsoid"});
        for (const [x, y] of svg.id === "practice" ? [] : PRACTICE) {
            const n = normalOfEllipsoid(x - EXAMPLE.middle[0], EXAMPLE.middle[1] - y, EXAMPLE.axes);
            const bad = [-n[1] * 0.8, n[0] * 0.8 - 0.35, n[2]], length = Math.hypot(...bad);
            const shown = svg.id === "good" ? n : bad.map(value => value / length);
            new Drawn(svg).show([x, y], shown, EXAMPLE.radius);
        }
    }
}

let keys = {}; // key -> what it does in the section that is shown

function practice() {
    show("practicing");
    const svg = $("practice"), gauge = new Drawn(svg);
    let at = 0, n = anywhere(Math.random), moved = false;
    const draw = () => {
        gauge.show(PRACTICE[at], n, EXAMPLE.radius);
        const [x, y] = PRACTICE[at];
        const truth = normalOfEllipsoid(x - EXAMPLE.middle[0], EXAMPLE.middle[1] - y, EXAMPLE.axes);
        const off = degreesBetween(n, truth);
        $("hint").textContent = !moved ? "Drag the gauge." : off < EXAMPLE.good ? "Good: it lies on the surface. Press space."
            : `Not yet: it is ${Math.round(off)} degrees off.`;
        gauge.color(moved && off < EXAMPLE.good ? GREEN : "#e60");
    };
    onDrag(svg, () => PRACTICE[at], (dx, dy) => { n = dragged(dx, dy, EXAMPLE.radius); moved = true; draw(); });
    const next = () => {
        if (!moved) return;
        if (++at < PRACTICE.length) {
            n = anywhere(Math.random), moved = false;
            draw();
        } else {
            gauge.group.remove();
            begin();
        }
    };
    keys = {" ": next, Enter: next};
    draw();
}

function begin() {
    const told = notes.read(), stimulus = STUDY.stimuli[told.stimulus];
    const device = {pointer: matchMedia("(pointer: coarse)").matches ? "touch" : "mouse", ratio: devicePixelRatio,
                    width: innerWidth, height: innerHeight};
    const session = new Session(STUDY, stimulus, {participant: told.participant, device}, told.session, Math.random,
                                () => performance.now());
    const svg = $("picture");
    svg.replaceChildren();
    shape(svg, "image", {href: stimulus.picture, width: STUDY.size[0], height: STUDY.size[1]});
    const gauge = new Drawn(svg);
    const draw = () => {
        if (session.done) return finish(session, told);
        gauge.show(session.place, session.normal, STUDY.radius);
        $("count").textContent = `Gauge ${session.at + 1} of ${session.steps.length}`;
        $("told").textContent = "";
    };
    onDrag(svg, () => session.place, (dx, dy) => { session.turn(dragged(dx, dy, STUDY.radius)); draw(); });
    const next = () => {
        if (session.next()) draw();
        else $("told").textContent = "Drag the gauge first.";
    };
    const back = () => { if (session.back()) draw(); };
    keys = {" ": next, Enter: next, Backspace: back};
    $("next").onclick = next;
    $("back").onclick = back;
    $("stop").onclick = () => save(session);
    window.onbeforeunload = event => event.preventDefault();
    show("setting");
    draw();
}

function save(session) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([session.lines()], {type: "application/x-ndjson"}));
    link.download = `${STUDY.model}-${session.who.participant}-${session.number}.jsonl`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function finish(session, told) {
    window.onbeforeunload = null;
    keys = {};
    const [following] = SETS.slice(session.number + 1);
    ++told.finished[told.stimulus];
    notes.write({...told, session: session.number + 1});
    $("save").onclick = () => save(session);
    $("again").hidden = !following;
    if (following) $("again").textContent = `Another ${(following[1] - following[0]) * 2} gauges`;
    $("again").onclick = begin;
    $("other").onclick = () => { newParticipant(); show("start"); keys = {}; };
    show("finished");
    save(session);
}

document.addEventListener("keydown", event => {
    if (event.repeat || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
});
document.addEventListener("click", () => document.activeElement?.blur()); // or space would press a button again
addExamples();
const known = notes.read();
if (!known.participant || known.session >= SETS.length) newParticipant();
$("go").onclick = practice;
$("skip").onclick = begin;
show("start");
