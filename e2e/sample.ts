import { isInSample } from '../scripts/gate/sample.mjs'

/** The part of four that `npm run test:full` draws by the commit's id; undefined if everything runs. */
const part = process.env['BOTGARTEN_SAMPLE']

/** Does this run hold the test of this name? Four parts together hold all. */
export const isSampled = (name: string): boolean => part === undefined || isInSample(name, Number(part))
