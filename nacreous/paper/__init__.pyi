from . import cutting as cutting
from . import make as make
