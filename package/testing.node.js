import { catalogue } from './catalogue.js'
import * as host from './node.js'
import { describedBy } from './own.js'
import { conformBy } from './testing/suite.js'

/** Says what a planner in JavaScript does not keep to. */
export const conform = (planner, options) => conformBy({ ...host, describedBy }, catalogue().scenes, planner, options)
