// `npm run attack:guess`: for ten minutes of a fake clock an attacker guesses codes and pictures, a hundred times a second and
// also from the children's own address, while thirty of them join; on SQLite and on PostgreSQL.
import { spawnSync } from 'node:child_process'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { runtime } from '../prepare/runtime.mjs'

const vitest = inRepo('node_modules', 'vitest', 'vitest.mjs')
const { status } = spawnSync(
  runtime(),
  [vitest, 'run', 'packages/classroom/joining/attack.slow.test.ts', '--testTimeout=900000'],
  { cwd: inRepo(), env: { ...process.env, BOTGARTEN_LONG: '1' }, stdio: 'inherit' },
)
process.exitCode = status ?? 1
