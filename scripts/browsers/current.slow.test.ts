import { expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { npmAside } from '../prepare/run.mjs'

test('no script uses an API that a promised browser lacks, and docs/browsers.md is up to date', async () => {
  const { code, said } = await npmAside(['run', '--silent', 'check:browsers'], { cwd: inHouse('.') })
  expect([code, said]).toEqual([0, ''])
}, 300_000)
