import { execFileSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { house as repoRoot } from '../prepare/house.mjs'

/** The number of samples that together cover everything. */
export const PARTS = 4

const numberOf = (text) => createHash('sha256').update(text).digest().readUInt32BE(0)

/** @param {string} id a commit's id, or the number of a part, 0 to 3 @returns {number} 0 to 3 */
export const partOf = (id) => (/^[0-3]$/.test(id) ? Number(id) : numberOf(id) % PARTS)

/** The id of the commit that is checked out; `0` where there is no git. */
export function commitId() {
  try {
    return execFileSync('git', ['rev-parse', 'HEAD'], { cwd: repoRoot, encoding: 'utf8' }).trim()
  } catch {
    return '0'
  }
}

/** Does this part of four hold the test? @param {string} name @param {number} part */
export const isInSample = (name, part) => numberOf(name) % PARTS === part
