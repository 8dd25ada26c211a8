"""What is done in the window; see inside.py. What a scenario returns is for the tests to judge."""

import math
import sys
import threading
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1] / "blender"))

import bpy
import numpy as np
import scenes
from mathutils import Matrix, Quaternion
from the_addon import box_mesh, fovea, new_object, part
from watch import Watch
from window import screen

SHARED = Path(__file__).parents[3] / "shared"
LITTLE, PLENTY = 1, 10000  # ms for a draw: no machine keeps the one, every machine the other
camera, caretaker = part("blender.camera"), part("blender.caretaker")


def opened(spec=None):
    """A scene in a 3D viewport that fills the window, in Rendered shading, refined; gives the Watch."""
    if spec:
        scenes.build(spec, SHARED if SHARED.is_dir() else None)
    scene = bpy.context.scene
    scene.render.engine = "FOVEA"
    scene.view_settings.view_transform = "Standard"
    scene.render.dither_intensity = 0
    yield from screen.fill()
    watch = Watch()
    screen.space().shading.type = "RENDERED"
    yield from watch.refined()
    return watch


def turn(degrees):
    """Orbits the view."""
    view = screen.space().region_3d
    view.view_rotation = Quaternion((0, 0, 1), math.radians(degrees)) @ view.view_rotation


def still(folder, name):
    """(H, W, 3) float32: the final render."""
    path, scene = folder / f"{name}.png", bpy.context.scene
    scene.render.filepath = str(path)
    scene.render.image_settings.file_format = "PNG"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[:, :, :3]


def frame():
    """Left, lower, width and height of the camera's frame in the viewport, in pixels."""
    with screen.override():
        depsgraph = bpy.context.evaluated_depsgraph_get()
        screen.space().region_3d.update()
        return camera.of_region(bpy.context, depsgraph).frame


def align(width):
    """Zooms and shifts the camera view until its frame is so many pixels wide and starts at whole ones."""
    view = screen.space().region_3d
    view.view_perspective = "CAMERA"
    view.view_camera_offset = (0, 0)
    low, high = -30.0, 300.0
    for _ in range(40):
        view.view_camera_zoom = (low + high) / 2
        low, high = (view.view_camera_zoom, high) if frame()[2] < width else (low, view.view_camera_zoom)
    for axis in (0, 1):
        start, offset = frame()[axis], list(view.view_camera_offset)
        offset[axis] += 1e-3
        view.view_camera_offset = offset
        offset[axis] += 1e-3 * ((round(start) - start) / (frame()[axis] - start) - 1)
        view.view_camera_offset = offset
    return frame()


def camera_view(folder):
    """The viewport's picture inside the camera's frame beside the final render, for several cameras; once with pens
    that are a quarter wider, which must not pass for the same."""
    watch = yield from opened("suzanne:3")
    scene, found = bpy.context.scene, {}
    obj = scene.camera
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 360, 100
    place = obj.matrix_world.copy()

    align(640)
    yield from watch.refined()
    found["coarse"] = yield from coarse(watch, obj)
    obj.matrix_world = place

    def beside(name):
        left, lower, width, height = (round(number) for number in align(640))
        exact = frame()
        yield from watch.refined()
        seen = screen.picture()[lower : lower + height, left : left + width]
        np.save(folder / f"{name}.npy", seen)
        found[name] = {"frame": exact, **likeness(seen, still(folder, name))}

    yield from beside("perspective")
    obj.data.shift_x, obj.data.shift_y = 0.15, -0.1
    yield from beside("shift")
    obj.data.show_passepartout, obj.data.passepartout_alpha = True, 1.0
    screen.space().lock_camera = True
    passepartout(screen.space().overlay)
    yield from beside("passepartout")
    found["outside"] = float(screen.picture()[:100].mean())
    screen.space().overlay.show_overlays = False
    obj.data.shift_x = obj.data.shift_y = 0
    obj.data.type, obj.data.ortho_scale = "ORTHO", 3.0
    yield from beside("orthographic")
    scene.render.film_transparent = False
    obj.matrix_world = Matrix.Rotation(0.5, 4, "Z") @ place
    yield from beside("moved")
    left, lower, width, height = (round(number) for number in frame())
    before = still(folder, "before")
    for line_set in part("blender.style_data").own(scene).line_sets:
        line_set.pen.width *= 1.25
    yield from watch.refined()
    wider = screen.picture()[lower : lower + height, left : left + width]
    found["wider"] = likeness(wider, before)
    return found


def coarse(watch, obj):
    """A draft of half the size beside the refined picture: how far apart they are where blurred, how much ink each has,
    and the same when the draft is shifted by two pixels of it."""
    budget = part("budget")
    old, budget.Budget.choose = budget.Budget.choose, lambda *_: 4
    obj.matrix_world = Matrix.Rotation(0.1, 4, "Z") @ obj.matrix_world
    screen.swap()
    chosen = watch.of(screen.area()).shown.quality
    draft = screen.picture()
    budget.Budget.choose = old
    yield from watch.refined()
    final = screen.picture()
    shifted = (np.roll(draft, by, axis) for by, axis in ((0, 0), (4, 0), (4, 1)))
    apart = [float(np.abs(blurred(image) - blurred(final)).mean()) for image in shifted]
    return {"quality": chosen, "apart": apart, "ink": [float((1 - image).mean()) for image in (draft, final)]}


def blurred(image):
    """Means of squares of 4 pixels."""
    height, width = (size // 4 * 4 for size in image.shape[:2])
    return image[:height, :width].reshape(height // 4, 4, width // 4, 4, 3).mean(axis=(1, 3))


def passepartout(overlay):
    """Of all overlays only what darkens what the camera does not see."""
    overlay.show_overlays = True
    others = "floor axis_x axis_y cursor relationship_lines outline_selected object_origins text"
    for name in others.split():
        setattr(overlay, f"show_{name}", False)
    for obj in bpy.context.scene.objects:
        obj.select_set(False)
        obj.hide_set(obj.type == "LIGHT")


def likeness(seen, final):
    """Mean of the differences, share of pixels that differ by more than 16 of 255, and how much ink there is."""
    inside = np.s_[2:-2, 2:-2]  # Blender draws the frame's border
    difference = np.abs(seen - final)[inside].max(axis=2)
    ink = (float((1 - image[inside]).mean()) for image in (seen, final))
    return {"mean": float(difference.mean()), "apart": float((difference > 16 / 255).mean()), "ink": list(ink)}


def orbit(folder):
    """30 steps around the office, or a smaller scene where its models are missing: in a budget that nothing keeps, so
    that it does not matter how fast the machine is; then a few in one that everything keeps."""
    watch = yield from opened("office" if SHARED.is_dir() else "demo")
    first = {"read": watch.read, "draws": watch.draws}
    screen.space().region_3d.view_perspective = "PERSP"
    yield from watch.refined()
    at_rest = screen.picture()
    settings = bpy.context.scene.fovea_viewport
    settings.budget_ms = LITTLE
    watch.reset()
    pictures = []
    for _ in range(30):
        turn(3)
        screen.swap()
        pictures.append(screen.picture()[::8, ::8].copy())
        yield
    moving = {"read": watch.read, "longest": watch.longest, "drafts": watch.drafts, "draws": watch.draws}
    moving["changed"] = sum(bool((a != b).any()) for a, b in zip(pictures, pictures[1:]))
    yield from watch.refined()
    refined = watch.of(screen.area()).shown.quality
    watch.reset()
    yield 2.0
    idle = {"draws": watch.draws, "timer": bpy.app.timers.is_registered(caretaker.tick), "threads": threads()}
    turn(-90)
    yield from watch.refined()
    back = float(np.abs(screen.picture() - at_rest)[16:].mean())
    settings.budget_ms = PLENTY
    watch.reset()
    for _ in range(4):
        turn(3)
        screen.swap()
        yield
    yield from watch.refined()
    return {"first": first, "moving": moving, "refined": refined, "idle": idle, "back": back, "plenty": watch.drafts}


def threads():
    return [thread.name for thread in threading.enumerate() if thread.name.startswith("Fovea")]


class Steps:
    """Does things to a scene, one after the other, each seen refined; keeps what went wrong."""

    def __init__(self, watch):
        self.watch, self.pictures = watch, {}

    def step(self, name, act, *arguments, **options):
        """Does something and keeps what is seen then, as 'name'."""
        with screen.override():
            act(*arguments, **options)
        yield from self.watch.refined()
        self.pictures[name] = screen.picture()[16:]

    def differ(self, first, second):
        return float(np.abs(self.pictures[first] - self.pictures[second]).mean())


def operators(folder):
    """What artists do while they look at the picture."""
    watch = yield from opened("boxes:2")
    steps, ops = Steps(watch), bpy.ops
    step = steps.step
    yield from step("start", ops.ed.undo_push, message="start")
    yield from step("selected", ops.object.select_all, "EXEC_DEFAULT", True, action="SELECT")
    reads = watch.read
    yield from step("none", ops.object.select_all, "EXEC_DEFAULT", True, action="DESELECT")
    told = {"read of a selection": watch.read - reads}
    yield from step("added", ops.mesh.primitive_monkey_add, "EXEC_DEFAULT", True, location=(0, 0, 4), size=4)
    yield from step("moved", ops.transform.translate, "EXEC_DEFAULT", True, value=(1, 0, 0))
    yield from step("undone", ops.ed.undo)
    yield from step("redone", ops.ed.redo)
    yield from step("deleted", ops.object.delete, "EXEC_DEFAULT", True)
    yield from step("back", ops.ed.undo)
    bpy.context.view_layer.objects.active = bpy.data.objects["Suzanne"]
    yield from step("edited", ops.object.mode_set, "EXEC_DEFAULT", True, mode="EDIT")
    yield from step("subdivided", ops.mesh.subdivide, "EXEC_DEFAULT", True)
    yield from step("left", ops.object.mode_set, "EXEC_DEFAULT", True, mode="OBJECT")
    yield from step("alone", ops.view3d.localview)
    yield from step("together", ops.view3d.localview)
    yield from step("hidden", bpy.data.objects["Suzanne"].hide_set, True)
    yield from step("shown", bpy.data.objects["Suzanne"].hide_set, False)
    same = "start selected,selected none,added undone,moved redone,moved back,left together,left shown"
    other = "start added,added moved,moved deleted,back left,left alone,left hidden"
    told["same"], told["other"] = (
        {pair: steps.differ(*pair.split()) for pair in pairs.split(",")} for pairs in (same, other)
    )
    told["calm"] = is_calm()
    return told


def events(folder):
    """The view turned by the mouse, an object grabbed and put down, and that undone by keys."""
    watch = yield from opened("boxes:2")
    steps, obj = Steps(watch), next(o for o in bpy.context.scene.objects if o.type == "MESH")
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    yield from steps.step("start", bpy.ops.ed.undo_push, message="start")
    told = {"reads": watch.read}
    yield from drag("MIDDLEMOUSE", (400, 300), (520, 340))
    yield from steps.step("turned", bool)
    told["read to turn"] = watch.read - told.pop("reads")
    reads = watch.read
    yield from press("G", (400, 300))
    for x in range(400, 480, 10):
        yield from event("MOUSEMOVE", "NOTHING", (x, 320))
    yield from press("LEFTMOUSE", (480, 320))
    yield from steps.step("grabbed", bool)
    told["read to grab"] = watch.read - reads
    yield from event("Z", "PRESS", (480, 320), ctrl=True)
    yield from event("Z", "RELEASE", (480, 320))
    yield from steps.step("undone", bool)
    pairs = ("start", "turned"), ("turned", "grabbed"), ("turned", "undone")
    told["differences"] = [steps.differ(*pair) for pair in pairs]
    told["calm"] = is_calm()
    return told


def event(kind, value, place, **keys):
    """One event, and time for Blender to handle it."""
    bpy.context.window_manager.windows[0].event_simulate(type=kind, value=value, x=place[0], y=place[1], **keys)
    yield from screen.rest(0.03)


def press(kind, place):
    yield from event(kind, "PRESS", place)
    yield from event(kind, "RELEASE", place)


def drag(button, start, end, steps=10):
    yield from event("MOUSEMOVE", "NOTHING", start)
    yield from event(button, "PRESS", start)
    for i in range(1, steps + 1):
        place = tuple(round(a + (b - a) * i / steps) for a, b in zip(start, end))
        yield from event("MOUSEMOVE", "NOTHING", place)
    yield from event(button, "RELEASE", end)


def is_calm():
    """Whether nothing is under way."""
    return not threads() and not bpy.app.timers.is_registered(caretaker.tick)


def shapes(folder):
    """Shape keys, an armature, playback, a style, several viewports, orthographic views."""
    watch = yield from opened("boxes:2")
    steps, layer, held = Steps(watch), bpy.context.view_layer, part("blender.style_data").own(bpy.context.scene)
    obj = new_object(box_mesh(1.5), "Shaped", (0, 0, 5))
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Wide")
    for point in key.data:
        point.co.x *= 2
    yield from steps.step("shape", setattr, key, "value", 0.0)
    yield from steps.step("wide", setattr, key, "value", 1.0)
    bones = new_object(bpy.data.armatures.new("Bones"), "Bones")
    layer.objects.active = bones
    with screen.override():
        bpy.ops.object.mode_set(mode="EDIT")
        bone = bones.data.edit_bones.new("Bone")
        bone.head, bone.tail = (0, 0, 5), (0, 0, 7)
        bpy.ops.object.mode_set(mode="OBJECT")
    obj.vertex_groups.new(name="Bone").add(range(8), 1.0, "ADD")
    obj.modifiers.new("Armature", "ARMATURE").object = bones
    yield from steps.step("boned", setattr, bones.pose.bones["Bone"], "location", (0, 0, 0))
    yield from steps.step("posed", setattr, bones.pose.bones["Bone"], "location", (2, 0, 0))
    reads = watch.read
    yield from steps.step("paper", setattr, held.paper, "color", (0.5, 0.5, 0.5))
    told = {"read of a style": watch.read - reads}
    yield from steps.step("top", bpy.ops.view3d.view_axis, type="TOP")
    told["played"] = yield from play(watch, obj)
    yield from screen.until(lambda: not watch.of(screen.area()).playing)
    yield from watch.refined()
    told["after playing"] = watch.of(screen.area()).shown.quality
    told["two"] = yield from two_viewports(watch)
    pairs = ("shape", "wide"), ("boned", "posed"), ("posed", "paper"), ("paper", "top")
    told["differences"] = {f"{a}, {b}": steps.differ(a, b) for a, b in pairs}
    told["calm"] = is_calm()
    return told


def play(watch, obj):
    """Animation playback: pictures come, none is refined; when it ends, the last one is."""
    for number, place in ((1, 0.0), (20, 4.0)):
        obj.location.x = place
        obj.keyframe_insert("location", frame=number)
    with screen.override():
        bpy.ops.screen.animation_play()
    yield from screen.rest(0.5)
    watch.reset()
    yield from screen.rest(2.0)
    told = {"draws": watch.draws, "read": watch.read}
    with screen.override():
        bpy.ops.screen.animation_cancel(restore_frame=False)
    return told


def two_viewports(watch):
    """Both refined, also when the scene changes; and alike where they look from the same place."""
    with screen.override():
        bpy.ops.screen.back_to_previous()
    yield from screen.rest(0.3)
    with screen.override():
        bpy.ops.screen.area_split(direction="VERTICAL", factor=0.5)
    yield from screen.rest(0.3)
    both = [screen.area(0), screen.area(1)]
    for one in both:
        one.spaces.active.shading.type = "RENDERED"
    yield from watch.refined(*both)
    bpy.data.objects["Shaped"].location.z += 1
    turn(20)
    yield from watch.refined(*both)
    return [watch.of(one).shown.quality for one in both]


def on_gpu(folder):
    """Drawn by OpenGL, in the viewport's own context: beside what the CPU draws, while it turns, and at rest."""
    watch = yield from opened("boxes:3")
    settings, by_cpu = bpy.context.scene.fovea, screen.picture()
    settings.backend = "GPU"
    yield from watch.refined()
    told = {"apart": float(np.abs(screen.picture() - by_cpu)[16:].mean()), "ink": float((1 - by_cpu[16:]).mean())}
    settings.visibility = "ATLAS"
    yield from watch.refined()
    told["atlas apart"] = float(np.abs(screen.picture() - by_cpu)[16:].mean())
    for _ in range(5):
        turn(3)
        screen.swap()
        yield
    yield from watch.refined()
    told["drawn by"] = part("blender.session").last_statistics()["backend"]
    settings.backend, settings.visibility = "CPU", "AUTO"
    turn(-15)
    yield from watch.refined()
    told["back"] = float(np.abs(screen.picture() - by_cpu)[16:].mean())
    told["calm"] = is_calm()
    return told


def memory():
    """MB that this process has allocated. Pages of files are its own or not by what other processes do."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return sum(int(line.split()[1]) for line in lines if line.startswith(("RssAnon", "RssShmem"))) / 1024


def switching(folder):
    """Engines and shadings, back and forth, in part while they are refined; MB of memory after each of 20 rounds."""
    watch = yield from opened("suzanne:3")
    scene, told = bpy.context.scene, []
    for turn_number in range(20):
        scene.render.engine = "BLENDER_WORKBENCH"
        yield from screen.rest(0.1)
        scene.render.engine = "FOVEA"
        yield from watch.refined()
        screen.space().shading.type = "SOLID"
        yield from screen.rest(0.1)
        screen.space().shading.type = "RENDERED"
        turn(5)
        yield
        if turn_number % 2:
            yield from watch.refined()
        told.append(memory())
    return {"memory": told, "calm": is_calm()}


def leftovers():
    """What an add-on may leave behind in Blender."""
    kinds = (bpy.types.PropertyGroup, bpy.types.Panel, bpy.types.Operator, bpy.types.RenderEngine)
    classes = [cls for kind in kinds for cls in kind.__subclasses__() if getattr(cls, "is_registered", False)]
    handlers = {name: getattr(bpy.app.handlers, name) for name in dir(bpy.app.handlers)}
    owners = [getattr(bpy.types, kind) for kind in ("Scene", "Object", "Material")]
    return {
        "classes": sorted(cls.__name__ for cls in classes),
        "handlers": {name: len(found) for name, found in handlers.items() if isinstance(found, list)},
        "properties": sorted(name for owner in owners for name in dir(owner)),
        "timer": bpy.app.timers.is_registered(caretaker.tick),
        "threads": threads(),
    }


def disabling(folder):
    """Disabled while it draws; then registered and unregistered again and again."""
    watch = yield from opened("demo")
    name = fovea.__name__
    turn(30)
    screen.swap()
    watch.end()
    with screen.override():
        bpy.ops.preferences.addon_disable(module=name)
    off = leftovers()
    told = {"engine": bpy.context.scene.render.engine, "off": {key: off[key] for key in ("timer", "threads")}}
    # Blender goes on with EEVEE, which takes a minute to begin in software.
    bpy.context.scene.render.engine = "BLENDER_WORKBENCH"
    screen.space().shading.type = "SOLID"
    yield from screen.rest(0.5)
    for _ in range(20):
        fovea.register()
        fovea.unregister()
        yield
    told["left"] = {key: (value, off[key]) for key, value in leftovers().items() if value != off[key]}
    told["names"] = [cls for cls in leftovers()["classes"] if "ovea" in cls]
    with screen.override():
        bpy.ops.preferences.addon_enable(module=name)
    bpy.context.scene.render.engine = "FOVEA"
    screen.space().shading.type = "RENDERED"
    watch = Watch()
    yield from watch.refined()
    told["again"] = watch.draws
    return told
