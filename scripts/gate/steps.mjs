import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { house as repoRoot, inHouse as inRepo } from '../prepare/house.mjs'
import { browserSuite } from './suite.mjs'
import { listFiles } from './tree.mjs'

/** Files with steps through features, each with the features that its tests are tagged with. */
export const listSteps = () =>
  listFiles('e2e/steps', '.spec.ts').map((file) => {
    const tags = readFileSync(inRepo(file), 'utf8').matchAll(/'@([\w-]+)'/g)
    return { file, features: [...new Set([...tags].map(([, feature]) => feature))] }
  })

/** Paths that the last commit and uncommitted changes touch; none without git, or in a clone that has one commit alone. */
export function changedPaths() {
  const git = (...args) =>
    execFileSync('git', args, { cwd: repoRoot, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] })
      .split('\0')
      .filter(Boolean)
  try {
    return [
      ...git('diff', '--name-only', '-z', 'HEAD~1'),
      ...git('ls-files', '--others', '--exclude-standard', '-z'),
    ]
  } catch {
    return []
  }
}

const isOf = (path, { file, features }) =>
  path === file || features.some((feature) => path.startsWith(`apps/web/src/features/${feature}/`))

/** The steps of changed features. @param {readonly string[]} changed paths */
export const stepsOf = (changed, steps = listSteps()) =>
  steps.filter((one) => changed.some((path) => isOf(path, one))).map(({ file }) => file)

/** Steps through features in a browser. @param {Pick<import('./suite.mjs').Suite, 'files' | 'keyOf'> & { shard?: string | null }} options */
export const stepsSuite = (options) =>
  browserSuite({ ...options, name: 'steps through features', script: 'test:steps' })
