// Gives a WebAssembly program under Node the environment of its process (emcc --pre-js).
Module['preRun'] = () => Object.assign(ENV, process.env);
