// SPDX-License-Identifier: GPL-3.0-or-later
// A job type of Flamenco: frames that are whole, recorded, and rendered once, by the file's engine and output settings.
// Copy it to the folder `scripts` beside flamenco-manager. Workers need the extension enabled; their Blender is started
// without --factory-startup, as by the variable blenderArgs of a new manager.

const JOB_TYPE = {
    label: "Fovea Frames",
    settings: [
        {key: "frames", type: "string", required: true, eval: "f'{C.scene.frame_start}-{C.scene.frame_end}'",
         evalInfo: {showLinkButton: true, description: "Scene frame range"},
         description: "Frames of the animation: 1-250 or 1-100,150"},
        {key: "chunk_size", type: "int32", default: 10, propargs: {min: 1}, visible: "submission",
         description: "Frames of one task; each task starts Blender once"},
        {key: "output", type: "string", subtype: "file_path", required: true, visible: "submission",
         eval: "str(abspath(C.scene.render.filepath))", description: "Place of the frames, with ###### for their number"},
        {key: "backend", type: "string", choices: ["cpu", "gpu"], default: "cpu", visible: "submission",
         description: "Who draws lines: pictures of the CPU are the same on every machine"},
        {key: "blendfile", type: "string", required: true, visible: "web", eval: "bpy.data.filepath",
         description: "The file that is rendered"},
    ],
};

// Flamenco's tasks have no environment of their own, and options of Blender are read in their order.
function settingUp(settings) {
    return "import os; os.environ.update(FOVEA_RESUME='1', FOVEA_BACKEND='" + settings.backend + "'); " +
        "from bl_ext.user_default.fovea.render import whole_frames; whole_frames.switch_on()";
}

// As one animation, if it is one range: then what frames have in common is found once.
function chosenFrames(chunk) {
    const range = /^(\d+)-(\d+)$/.exec(chunk);
    return range
        ? ["--frame-start", range[1], "--frame-end", range[2], "--frame-jump", "1", "--render-anim"]
        : ["--render-frame", chunk.replace(/-/g, "..")];
}

function compileJob(job) {
    const settings = job.settings;
    const check = author.Task("check", "misc");
    for (const chunk of frameChunker(settings.frames, settings.chunk_size)) {
        const task = author.Task("render-" + chunk, "blender");
        task.addCommand(author.Command("blender-render", {
            exe: "{blender}",
            exeArgs: "{blenderArgs}",
            argsBefore: ["--python-exit-code", "1", "--python-expr", settingUp(settings)],
            blendfile: settings.blendfile,
            args: ["--render-output", settings.output].concat(chosenFrames(chunk)),
        }));
        check.addDependency(task);
        job.addTask(task);
    }
    check.addCommand(author.Command("exec", {
        exe: "{blender}",
        args: ["--command", "fovea_check", path.dirname(settings.output), "--frames", settings.frames],
    }));
    job.addTask(check);
}
