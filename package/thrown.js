/*
 * Errors on the way between threads. They would lose their fields: they are sent as plain data and built again on the other side.
 */
import { transferHandlers } from 'comlink'
import { ModuleDead } from './guard.js'

/** An error as plain data. */
export function dataOf(error) {
  const { name, message, stack, cause } = error
  return { name, message, stack, ...(cause === undefined ? {} : { cause: String(cause) }), ...error }
}

export function errorOf({ message, cause, ...rest }) {
  const error = new Error(message, cause === undefined ? undefined : { cause })
  for (const [name, value] of Object.entries(rest)) {
    Object.defineProperty(error, name, { value, enumerable: name !== 'name' && name !== 'stack', configurable: true, writable: true })
  }
  return rest.code === 'module-dead' ? Object.setPrototypeOf(error, ModuleDead.prototype) : error
}

transferHandlers.set('throw', {
  canHandle: transferHandlers.get('throw').canHandle,
  serialize: ({ value }) => [value instanceof Error ? { error: dataOf(value) } : { value }, []],
  deserialize({ error, value }) {
    throw error ? errorOf(error) : value
  },
})
