"""An instance of the FMU whose variables go by their names, and whose log can be read."""

from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE

STEP = 50e-6


class Slave:
    """One instance; `messages` holds (status, category, text) of everything that it logged."""

    def __init__(self, folder, description, name="impact", logging=False, guid=None):
        self.references = {variable.name: variable.valueReference for variable in description.modelVariables}
        self.messages = []
        self.fmu = FMU2Slave(
            guid=guid or description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName=name,
        )
        # Kept as attributes: the library calls them as long as the instance lives.
        self._logger = fmi2CallbackLoggerTYPE(self._log)
        self._callbacks = fmi2CallbackFunctions(logger=self._logger)
        self.fmu.instantiate(callbacks=self._callbacks, loggingOn=logging)

    def _log(self, _environment, _name, status, category, message):
        self.messages.append((status, category.decode(), message.decode()))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.fmu.fmi2FreeInstance(self.fmu.component)
        self.fmu.freeLibrary()

    def start(self, start_time=0.0, stop_time=None, **parameters):
        """From a new instance to the first step; a parameter's dot is written as two underscores."""
        self.fmu.setupExperiment(startTime=start_time, stopTime=stop_time)
        self.set(**parameters)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        return self

    def set(self, **values):
        """Sets variables: Booleans and integers as such, everything else as a Real."""
        for name, value in values.items():
            reference = [self.references[name.replace("__", ".")]]
            if isinstance(value, bool):
                self.fmu.setBoolean(reference, [value])
            else:
                (self.fmu.setInteger if isinstance(value, int) else self.fmu.setReal)(reference, [value])

    def real(self, name):
        return self.fmu.getReal([self.references[name]])[0]

    def integer(self, name):
        return self.fmu.getInteger([self.references[name]])[0]

    def boolean(self, name):
        return self.fmu.getBoolean([self.references[name]])[0]

    def trace_hash(self):
        return self.fmu.getString([self.references["result.trace_hash"]])[0].decode()

    def run(self, steps, size=STEP):
        """Makes communication steps of equal size; times accumulate as they do in a simple master."""
        time = self.real("time")
        for _ in range(steps):
            self.fmu.doStep(currentCommunicationPoint=time, communicationStepSize=size)
            time += size
        return self

    def bytes(self):
        """The whole state."""
        state = self.fmu.getFMUstate()
        try:
            return bytes(self.fmu.serializeFMUstate(state))
        finally:
            self.fmu.freeFMUstate(state)

    def restore(self, data):
        state = self.fmu.deSerializeFMUstate(data)
        try:
            self.fmu.setFMUstate(state)
        finally:
            self.fmu.freeFMUstate(state)

    def results(self):
        """Everything that a run is judged by, to the last bit."""
        names = [name for name in self.references if name.startswith(("result.", "energy."))]
        names.remove("result.trace_hash")
        return {**{name: self.real(name) for name in names}, "result.trace_hash": self.trace_hash()}
