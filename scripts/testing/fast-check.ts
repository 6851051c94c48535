// What tests import as `fast-check` (vitest.config.ts): in `npm test` the same cases on every machine and every run, in
// `npm run test:long` others each time. What fails says its seed: `BOTGARTEN_SEED=<seed>` tries that one.
import fc from '../../node_modules/fast-check/lib/fast-check.js'
import { isLong } from '../../packages/numbers/testing/long.ts'

const asked = process.env['BOTGARTEN_SEED']
if (asked !== undefined || !isLong)
  fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: asked === undefined ? 1 : Number(asked) })

export * from '../../node_modules/fast-check/lib/fast-check.js'
export default fc
