// What the script of a worker imports that is given to `WorkerSession.start`.
export {}
