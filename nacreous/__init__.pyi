from . import body as body
from . import card as card
from . import colour as colour
from . import file as file
from . import iridescence as iridescence
from . import measure as measure
from . import medium as medium
from . import nacre as nacre
from . import optics as optics
from . import paper as paper
from . import scaling as scaling
from . import spec as spec
from . import strand as strand
from . import study as study
from . import texture as texture
from . import trade as trade
from . import turn as turn
from .exposure import metered_exposure as metered_exposure
from .image import Image as Image
from .image import render as render
from .nacre import LayerStack as LayerStack
from .nacre import grow as grow
from .problem import InputError as InputError
from .spec import Pearl as Pearl
from .spec import Scene as Scene
from .spec import load as load

__version__: str
