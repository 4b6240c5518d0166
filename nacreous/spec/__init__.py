"""Pearl and scene files: what they may say, and every way in which they can be wrong.

A pearl and a scene are TOML files. Each key is declared once, in pearl.py, nacre.py, growth.py,
scene.py, row.py, camera.py, lamp.py or window.py, with its unit, range and source; loading,
messages and schema follow from that.
"""

from nacreous.spec.camera import Camera
from nacreous.spec.growth import Growth
from nacreous.spec.lamp import Lamp
from nacreous.spec.load import load
from nacreous.spec.nacre import Layers, Nacre
from nacreous.spec.pearl import Interference, Pearl, Surface, Texture
from nacreous.spec.row import Row
from nacreous.spec.scene import Scene, Sky, Table, Walls
from nacreous.spec.schema import json_schema
from nacreous.spec.window import Window

__all__ = [
    "Camera",
    "Growth",
    "Interference",
    "Lamp",
    "Layers",
    "Nacre",
    "Pearl",
    "Row",
    "Scene",
    "Sky",
    "Surface",
    "Table",
    "Texture",
    "Walls",
    "Window",
    "json_schema",
    "load",
]
