import { catalogue } from './catalogue.js'
import * as host from './node.js'
import { conformBy } from './testing/suite.js'

/** Says what a planner in JavaScript does not keep to. */
export const conform = (planner, options) => conformBy(host, catalogue().scenes, planner, options)
