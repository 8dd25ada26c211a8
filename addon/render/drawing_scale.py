# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings to scale: how the frame of an orthographic camera and the page of the style belong together."""

from bpy.props import FloatProperty

from ..style import style_data

LARGEST = 1e6  # N of a scale 1:N


def hindrance(scene):
    """Why a scene has no scale, as one sentence; None if it has one."""
    camera = scene.camera
    if camera is None or camera.type != "CAMERA":
        return "The scene has no camera: a drawing to scale needs one"
    if camera.data.type != "ORTHO":
        return f"Camera '{camera.name}' is not orthographic: a drawing has a scale only without perspective"
    return None


def frame_height(scene):
    """Height of the frame of the scene's orthographic camera, in meters."""
    corners = scene.camera.data.view_frame(scene=scene)
    return abs(corners[0].y - corners[1].y) * scene.unit_settings.scale_length


def page_height(scene):
    """Height of the page in millimeters, as the scene's style says."""
    tree = style_data.of(scene)
    return tree.fovea.paper.height_mm if tree else style_data.default().paper.height_mm


def scale_of(scene):
    """N of the scene's scale 1:N; 0 without one."""
    return 0.0 if hindrance(scene) else 1000.0 * frame_height(scene) / page_height(scene)


def set_scale(scene, wanted):
    """Makes the scene's scale 1:wanted by the size of the camera's frame; nothing without a scale."""
    now = scale_of(scene)
    if now > 0.0:
        scene.camera.data.ortho_scale *= wanted / now


def fit_page(scene, wanted):
    """Makes the scene's scale 1:wanted by the height of its style's page. ValueError without a scale."""
    if reason := hindrance(scene):
        raise ValueError(reason)
    style_data.own(scene).paper.height_mm = 1000.0 * frame_height(scene) / wanted


def annotations():
    """Property annotations for the scene's settings."""
    told = "N of the scale 1:N at which the camera's frame is drawn on the page; setting it sizes the frame"
    return {
        "drawing_scale": FloatProperty(
            name="Scale 1 :",
            description=told,
            min=0.0,
            max=LARGEST,
            soft_max=1000.0,
            precision=2,
            step=100,
            options={"SKIP_SAVE"},
            get=lambda settings: scale_of(settings.id_data),
            set=lambda settings, wanted: set_scale(settings.id_data, wanted) if wanted > 0.0 else None,
        )
    }
