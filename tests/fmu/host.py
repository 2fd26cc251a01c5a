# SPDX-License-Identifier: Apache-2.0
"""A small host of functional mock-up units (FMI 2.0, co-simulation): loads their library and steps instances."""
import ctypes
import pathlib
import urllib.parse
import xml.etree.ElementTree
import zipfile

REAL, INTEGER, BOOLEAN = ctypes.c_double, ctypes.c_int, ctypes.c_int
LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ctypes.c_void_p), ("release", ctypes.c_void_p), ("finished", ctypes.c_void_p), ("environment", ctypes.c_void_p)]


class State(ctypes.c_void_p):
    """A state that an instance has kept, and the host's time of it."""

    time = 0.0


class Unit:
    """A unit, unpacked into a folder."""

    def __init__(self, file, folder):
        self.folder = pathlib.Path(folder).absolute()
        with zipfile.ZipFile(file) as archive:
            archive.extractall(self.folder)
        self.description = xml.etree.ElementTree.parse(self.folder / "modelDescription.xml").getroot()
        self.identifier = self.description.find("CoSimulation").get("modelIdentifier")
        self.variables = {one.get("name"): one for one in self.description.find("ModelVariables")}
        self.library = ctypes.CDLL(str(self.folder / "binaries/linux64" / (self.identifier + ".so")))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.library.fmi2GetVersion.restype = self.library.fmi2GetTypesPlatform.restype = ctypes.c_char_p
        self.resources = "file://" + urllib.parse.quote(str(self.folder / "resources"))

    def made(self, name="one", guid=None, resources=None, logging=1):
        """An instance as it is made; its component is None where it is refused."""
        return Instance(self, name, guid or self.description.get("guid"), resources or self.resources, logging)

    def instance(self, name="one", guid=None, resources=None, **starts):
        """An instance with other starts than its own, at the end of its initialization."""
        made = self.made(name, guid, resources)
        if made.component:
            made.set(**starts)
            made.initialize()
        return made


class Instance:
    def __init__(self, unit, name, guid, resources, logging):
        self.unit, self.library, self.said, self.time = unit, unit.library, [], 0.0
        # The logger takes further arguments as printf does: the unit gives one text.
        self.logger = LOGGER(lambda environment, instance, status, category, form, text: self.said.append(text.decode()))
        self.callbacks = Callbacks(self.logger, None, None, None, None)
        self.component = self.library.fmi2Instantiate(name.encode(), 1, guid.encode(), resources.encode(), ctypes.byref(self.callbacks), 0, logging)

    def call(self, function, *arguments):
        status = getattr(self.library, function)(ctypes.c_void_p(self.component), *arguments)
        if status != 0:
            raise RuntimeError(f"{function}: status {status}: {'; '.join(self.said[-1:])}")

    def set_up(self, start=0.0, stop=None):
        self.call("fmi2SetupExperiment", 0, REAL(0), REAL(start), stop is not None, REAL(stop or 0.0))
        self.time = start

    def initialize(self, start=0.0, stop=None):
        self.set_up(start, stop)
        self.call("fmi2EnterInitializationMode")
        self.call("fmi2ExitInitializationMode")

    def place(self, name):
        variable = self.unit.variables[name]
        return (ctypes.c_uint * 1)(int(variable.get("valueReference"))), variable[0].tag

    def set(self, **values):
        for name, value in values.items():
            reference, kind = self.place(name)
            number = (REAL if kind == "Real" else INTEGER)(value)
            self.call("fmi2Set" + kind, reference, ctypes.c_size_t(1), ctypes.byref(number))

    def get(self, name):
        reference, kind = self.place(name)
        number = (REAL if kind == "Real" else INTEGER)()
        self.call("fmi2Get" + kind, reference, ctypes.c_size_t(1), ctypes.byref(number))
        return number.value

    def step(self, size):
        self.call("fmi2DoStep", REAL(self.time), REAL(size), 1)
        self.time += size

    def state(self):
        saved = State()
        saved.time = self.time
        self.call("fmi2GetFMUstate", ctypes.byref(saved))
        return saved

    def go_back(self, saved):
        self.call("fmi2SetFMUstate", saved)
        self.time = saved.time

    def free_state(self, saved):
        self.call("fmi2FreeFMUstate", ctypes.byref(saved))

    def to_bytes(self, saved):
        size = ctypes.c_size_t()
        self.call("fmi2SerializedFMUstateSize", saved, ctypes.byref(size))
        written = ctypes.create_string_buffer(size.value)
        self.call("fmi2SerializeFMUstate", saved, written, size)
        return written.raw

    def from_bytes(self, written, time=0.0):
        saved = State()
        saved.time = time
        self.call("fmi2DeSerializeFMUstate", written, ctypes.c_size_t(len(written)), ctypes.byref(saved))
        return saved

    def free(self):
        self.library.fmi2FreeInstance(ctypes.c_void_p(self.component))
        self.component = None
