import { atan2, cos, sin } from '@botgarten/numbers'

// The physics library takes its functions out of Math while it loads (running.md 7). This file is imported before it,
// return-math.ts after it, both by planck.ts alone.
/* eslint-disable no-restricted-properties -- kept to be given back */
export const native = { sin: Math.sin, cos: Math.cos, atan2: Math.atan2 }
/* eslint-enable no-restricted-properties */

Object.assign(Math, { sin, cos, atan2 })
