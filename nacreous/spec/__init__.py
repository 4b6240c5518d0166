"""Pearl and scene files: what they may say, and every way in which they can be wrong.

A pearl and a scene are TOML files. Each key is declared once, in the file of its section, such as
pearl.py, nacre.py, body.py, scene.py or lamp.py, with its unit, range and source; loading, messages
and schema follow from that.
"""

from nacreous.spec.blemishes import Blemishes
from nacreous.spec.body import Body
from nacreous.spec.camera import Camera
from nacreous.spec.coat import Coat
from nacreous.spec.film import Film
from nacreous.spec.growth import Growth
from nacreous.spec.inside import Inside
from nacreous.spec.interference import Interference
from nacreous.spec.lamp import Lamp
from nacreous.spec.load import load
from nacreous.spec.medium import Uniaxial
from nacreous.spec.nacre import Layers, Nacre
from nacreous.spec.pearl import Pearl
from nacreous.spec.pose import Pose
from nacreous.spec.row import Row
from nacreous.spec.scene import Scene, Sky, Table, Walls
from nacreous.spec.schema import json_schema
from nacreous.spec.shape import Shape
from nacreous.spec.surface import Surface
from nacreous.spec.texture import Texture
from nacreous.spec.window import Window

__all__ = [
    "Blemishes",
    "Body",
    "Camera",
    "Coat",
    "Film",
    "Growth",
    "Inside",
    "Interference",
    "Lamp",
    "Layers",
    "Nacre",
    "Pearl",
    "Pose",
    "Row",
    "Scene",
    "Shape",
    "Sky",
    "Surface",
    "Table",
    "Texture",
    "Uniaxial",
    "Walls",
    "Window",
    "json_schema",
    "load",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
