export * from './forage.js'

/** In Node everything is ready on import; this keeps code that calls `await init()` working. */
export default function init(): Promise<void>
