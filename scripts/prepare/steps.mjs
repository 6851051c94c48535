import { npm, npmAside } from './run.mjs'

/**
 * One npm script that counts as one check.
 * @typedef {{ name: string, script: string, args?: string[], env?: object }} Step
 * @typedef {{ passed: number, failed: number }} Count
 */

export const good = ({ failed }) => failed === 0

/** Runs one step. `aside`: what it says is shown as a whole at its end. */
export async function take(step, environment, aside = false) {
  const began = Date.now()
  const title = `\n── ${step.name} (npm run ${step.script})`
  if (!aside) console.log(title)
  const args = ['run', '--silent', step.script, ...(step.args ? ['--', ...step.args] : [])]
  const options = { env: { ...process.env, ...environment, ...step.env } }
  const { code, said } = aside ? await npmAside(args, options) : { code: await npm(args, options), said: '' }
  if (aside) console.log(`${title}\n${said}`)
  const counted = code === 0 ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 }
  const seconds = Math.round((Date.now() - began) / 1000)
  console.log(`── ${step.name}: ${good(counted) ? 'good' : 'FAILED'} (${seconds} s)`)
  return counted
}

/** One step after the other until one fails. */
export async function takeInOrder(steps, environment, aside = false) {
  const counts = []
  for (const step of steps) {
    counts.push(await take(step, environment, aside))
    if (!counts.every(good)) break
  }
  return counts
}
