import { expect, test } from 'vitest'
import self from '../../package.json' with { type: 'json' }
import { promised } from './promised.ts'

test('tools that read browserslist get the same versions', () => {
  const { safari, ...others } = promised
  const all = Object.entries({ safari, ios_saf: safari, ...others })
  expect(self.browserslist).toEqual(all.map(([name, version]) => `${name} >= ${version}`))
})
