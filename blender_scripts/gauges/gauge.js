// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of a study computes: gauges as in formulas.py, what a participant is shown in which order, and the lines
// that are saved. Vectors are [x, y, z], y up; places are pixels from the upper left.
"use strict";

const PIN = 1.2, STEEPEST = 88, SET = 30;

function normalOf(slant, tilt) {
    return [Math.sin(slant) * Math.cos(tilt), Math.sin(slant) * Math.sin(tilt), Math.cos(slant)];
}

// Of a pointer that is so far from the middle of a gauge, in pixels, y down as on screens.
function dragged(dx, dy, radius) {
    const far = Math.min(Math.hypot(dx, dy) / (2 * radius), 1);
    return normalOf(Math.asin(far) * STEEPEST / 90, Math.atan2(-dy, dx));
}

// The disc as an SVG ellipse, whose axis ry is turned by `turn` degrees, and the pin's end, from the middle.
function ellipse(n, radius) {
    const turn = Math.atan2(-n[1], n[0]) * 180 / Math.PI + 90;
    return {rx: radius, ry: radius * n[2], turn, pin: [PIN * radius * n[0], -PIN * radius * n[1]]};
}

// Every direction that gauges can be set to is equally likely.
function anywhere(random) {
    const least = Math.cos(STEEPEST * Math.PI / 180), z = least + (1 - least) * random();
    return normalOf(Math.acos(z), 2 * Math.PI * random());
}

function degreesBetween(a, b) {
    const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return Math.acos(Math.max(-1, Math.min(1, dot))) * 180 / Math.PI;
}

function shuffled(values, random) {
    const found = values.slice();
    for (let i = found.length - 1; i > 0; --i) {
        const k = Math.floor(random() * (i + 1));
        [found[i], found[k]] = [found[k], found[i]];
    }
    return found;
}

// First and last + 1 of the gauges of each set; of strings, which are at the end of all, two are a set.
function sets(all, strings = []) {
    const count = strings.length ? strings[0][0] : all, parts = Math.ceil(count / SET);
    const end = i => {
        const exact = i * count / parts, low = Math.floor(exact);
        return exact - low === 0.5 ? low + low % 2 : Math.round(exact); // as Python rounds
    };
    const pairs = strings.filter((_, i) => i % 2 === 0);
    return [...Array.from({length: parts}, (_, i) => [end(i), end(i + 1)]),
            ...pairs.map(([first, last], i) => [first, (strings[2 * i + 1] || [0, last])[1]])];
}

// Number of one of several, which is the likelier the fewer sessions it has: 1 / (sessions + 1).
function chosen(sessions, random) {
    const weights = sessions.map(count => 1 / (count + 1));
    let at = random() * weights.reduce((a, b) => a + b, 0);
    for (let i = 0; i < weights.length; ++i) if ((at -= weights[i]) < 0) return i;
    return weights.length - 1;
}

// One session: a set of gauges in random order, and the same again in another order.
class Session {
    // study: {study, build, model, radius, gauges: [[x, y]], strings: [[first, end]]}; stimulus: {style, sha256}; who: {participant, device}.
    constructor(study, stimulus, who, number, random, now) {
        Object.assign(this, {study, stimulus, who, number, random, now, at: 0});
        const all = sets(study.gauges.length, study.strings), [first, end] = all[number % all.length];
        const own = Array.from({length: end - first}, (_, i) => first + i);
        const step = repeat => gauge => ({gauge, repeat, start: anywhere(random), n: null, ms: 0, set: false});
        this.steps = [0, 1].flatMap(repeat => shuffled(own, random).map(step(repeat)));
        this.since = now();
    }

    get done() { return this.at === this.steps.length; }
    get step() { return this.steps[this.at]; }
    get normal() { return this.step.n || this.step.start; }
    get place() { return this.study.gauges[this.step.gauge]; }

    turn(n) {
        this.step.n = n;
    }

    // A gauge that was not touched is not set: false.
    next() {
        if (this.done || !this.step.n) return false;
        this.pause();
        this.step.set = true;
        ++this.at;
        return true;
    }

    back() {
        if (this.at === 0) return false;
        this.pause();
        --this.at;
        return true;
    }

    // Adds the time since the last step to the gauge that is shown.
    pause() {
        const now = this.now();
        if (!this.done) this.step.ms += now - this.since;
        this.since = now;
    }

    // Of all gauges that were set.
    lines() {
        const {study, build, model} = this.study, round = n => n.map(x => Math.round(x * 1e6) / 1e6);
        return this.steps.map((step, order) => ({step, order})).filter(({step}) => step.set)
            .map(({step, order}) => JSON.stringify({
                study, build, stimulus: this.stimulus.sha256, style: this.stimulus.style, model,
                participant: this.who.participant, session: this.number, order, gauge: step.gauge,
                x: this.study.gauges[step.gauge][0], y: this.study.gauges[step.gauge][1], repeat: step.repeat,
                n: round(step.n), ms: Math.round(step.ms), start: round(step.start), device: this.who.device,
            }) + "\n").join("");
    }
}

// The shape to practice on, half of an ellipsoid with half axes [a, b, c] around a middle.
function normalOfEllipsoid(x, y, [a, b, c]) {
    const z = c * Math.sqrt(Math.max(0, 1 - (x / a) ** 2 - (y / b) ** 2));
    const n = [x / a ** 2, y / b ** 2, z / c ** 2], length = Math.hypot(...n);
    return n.map(value => value / length);
}

if (typeof module !== "undefined") {
    module.exports = {
        normalOf, dragged, ellipse, anywhere, degreesBetween, shuffled, sets, chosen, Session, normalOfEllipsoid,
    };
}
