/*
 * The first part of the module by itself, for a picture before any text: the rest, and words, come with the package's
 * main entry, which may be imported later.
 */
import start from './glue.js'

let first

/**
 * Loads the first part. What it returns is for the loader. `source`: where it is, if it is not where this file is,
 * or what it was compiled to.
 */
export function begin(source) {
  first ??= start(source && { module_or_path: source }).catch((error) => {
    first = undefined
    throw error
  })
  return first
}
