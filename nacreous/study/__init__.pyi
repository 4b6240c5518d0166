from . import design as design
from . import plan as plan
from . import results as results
from . import running as running
from . import store as store
from . import task as task
