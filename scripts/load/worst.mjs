// `npm run load:worst [-- --seconds 35] [-- --postgres postgres://…] [-- --only "1,000 streams;all together"]`: one pupil does
// the worst while another class works; the times of that class are written to benchmarks/results/worst.md.
import { spawnSync } from 'node:child_process'
import { parseArgs } from 'node:util'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { runtime } from '../prepare/runtime.mjs'

const text = /** @type {const} */ ({ type: 'string' })
const { values } = parseArgs({ options: { seconds: text, postgres: text, only: text } })
const { seconds, postgres, only } = values
const env = {
  ...process.env,
  ...(seconds === undefined ? {} : { BENCH_SECONDS: seconds }),
  ...(postgres === undefined ? {} : { BENCH_POSTGRES: postgres }),
  ...(only === undefined ? {} : { BENCH_ONLY: only }),
}
const { status } = spawnSync(runtime(), [inRepo('benchmarks', 'run.ts'), 'worst'], { env, stdio: 'inherit' })
process.exitCode = status ?? 1
