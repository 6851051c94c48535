// `npm run attack:guess` and its siblings: each plays one kind of attack or fault at its whole length.
// The load that one pupil can make is measured by `npm run load:worst`.
import { spawnSync } from 'node:child_process'
import { inHouse as inRepo } from '../prepare/house.mjs'
import { runtime } from '../prepare/runtime.mjs'

/** Test files by the name of an attack. @type {Record<string, readonly string[]>} */
const attacks = {
  /** Codes and pictures, ten minutes of a fake clock, also from the children's own address, while thirty of them join. */
  guess: ['classroom/joining/attack.slow.test.ts'],
  /** 1,000 saves while the server is killed at random, on SQLite and on PostgreSQL; and stopped in each other way. */
  kill: ['classroom/projects/kill.slow.test.ts', 'server/stopping.test.ts'],
  /** PostgreSQL is killed, frozen and cut off; errors of a full, read-only or starting one get their answers. */
  postgres: [
    ...['classroom/database/postgres-faults.test.ts', 'classroom/database/errors.test.ts'],
    'server/nodes.test.ts',
  ],
  /** SQLite on a disk that is full, locked or read only, and with a file that is no database. */
  disk: ['classroom/database/faults.test.ts'],
  /** A backup, a copied folder, a dump and a reset machine put a class back to an earlier state. */
  restore: ['classroom/projects/put-back.test.ts'],
  /** The clock is an hour, a day or a year wrong, or begins in 1970. */
  clock: ['classroom/clock.test.ts'],
  /** Each route by each role, random requests by anyone, and requests while a class is deleted. */
  roles: [
    ...['classroom/roles.test.ts', 'classroom/random.test.ts', 'classroom/at-once.slow.test.ts'],
    'classroom/handle.test.ts',
  ],
  /** Whether an answer of a questionnaire leads to its pupil. */
  answers: ['classroom/questionnaires/attack.test.ts', 'classroom/questionnaires/tokens.test.ts'],
}

const [name = ''] = process.argv.slice(2)
const files = attacks[name]
if (files === undefined) {
  console.error(`There is no attack ${name}: ${Object.keys(attacks).join(', ')}.`)
  process.exitCode = 2
} else {
  const vitest = inRepo('node_modules', 'vitest', 'vitest.mjs')
  const paths = files.map((file) => `packages/${file}`)
  const { status } = spawnSync(runtime(), [vitest, 'run', ...paths, '--testTimeout=900000'], {
    cwd: inRepo(),
    env: { ...process.env, BOTGARTEN_LONG: '1' },
    stdio: 'inherit',
  })
  process.exitCode = status ?? 1
}
