import { isToBeBuilt } from '../prepare/build.mjs'
import { Trouble } from '../prepare/run.mjs'
import { takeInOrder } from '../prepare/steps.mjs'
import { browserSuite } from './suite.mjs'
import { listFiles } from './tree.mjs'

/** @param {string | undefined} text such as `1/3`: a part, and the number of parts @returns {string | null} null for everything */
export function readShard(text) {
  if (text === undefined) return null
  const [, index, count] = /^([1-9]\d*)\/([1-9]\d*)$/.exec(text) ?? []
  if (Number(index) <= Number(count)) return text
  throw new Trouble('--shard needs a part and a number of parts, such as 1/3.')
}

/** A further condition that decides how a file of a long run ends. @param {number} sample @param {string | null} shard */
export const modeOf = (sample, shard) => `sample ${sample}, shard ${shard ?? 'all'}`

/** Generated files and the build, which browser tests need; the build only if its sources have changed. @param {object} environment */
export const prepare = (environment) =>
  takeInOrder(
    [
      { name: 'generated files', script: 'generate' },
      ...(isToBeBuilt() ? [{ name: 'build', script: 'build' }] : []),
    ],
    environment,
  )

/** All walks to the end, each in the variant of a sample. @param {{ keyOf: (file: string) => string | null, shard: string | null }} options */
export const walkSuite = ({ keyOf, shard }) =>
  browserSuite({
    ...{ name: 'walks to the end', script: 'walk:some', keyOf, shard },
    files: listFiles('e2e/walk', '.walk.ts'),
  })
