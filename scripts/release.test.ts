import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import { inHouse } from './prepare/house.mjs'
import { Trouble } from './prepare/run.mjs'
import { released, versionFiles } from './release.ts'

const ours = versionFiles(inHouse('.'))

const files = new Map([
  ['package.json', '{\n  "name": "botgarten",\n  "version": "0.9.3"\n}\n'],
  ['packages/lab/package.json', '{\n  "name": "lab",\n  "version": "0.9.3",\n  "private": true\n}\n'],
  [
    'package-lock.json',
    JSON.stringify({
      version: '0.9.3',
      packages: {
        '': { version: '0.9.3' },
        'packages/lab': { version: '0.9.3' },
        'node_modules/idb': { version: '0.9.3' },
        'apps/cli/node_modules/ajv': { version: '0.9.3' },
      },
    }),
  ],
  ['CHANGELOG.md', '# Changelog\n\n## [Unreleased]\n\n### Added\n\n- A bell.\n\n## [0.9.3] - 2026-11-22\n'],
])

describe('today', () => {
  test('every package and the lock file say the version of the root', () => {
    const { version } = JSON.parse(ours.get('package.json')!) as { version: string }
    expect(ours.size).toBeGreaterThan(10)
    for (const [path, text] of ours) {
      if (path === 'CHANGELOG.md') expect(text).toMatch(new RegExp(`^## \\[${version}\\] - \\d`, 'm'))
      else expect([path, (JSON.parse(text) as { version: string }).version]).toEqual([path, version])
    }
  })

  test('a release changes versions and a heading, and nothing else', () => {
    for (const [path, text] of released(ours, '99.0.0', '2099-12-31')) {
      const before = ours.get(path)!.split('\n')
      const after = text.replace('\n## [99.0.0] - 2099-12-31\n', '').split('\n')
      expect(after).toHaveLength(before.length)
      const changed = after.filter((line, at) => line !== before[at])
      expect(changed.every((line) => /^ *"version": "99\.0\.0",?$/.test(line))).toBe(true)
      expect(text).toContain('99.0.0')
    }
  })
})

test('packages, lock file and changelog get the version, what comes from elsewhere keeps its own', () => {
  const after = released(files, '0.10.0', '2026-12-24')
  expect(after.get('package.json')).toBe('{\n  "name": "botgarten",\n  "version": "0.10.0"\n}\n')
  expect(after.get('packages/lab/package.json')).toContain('"version": "0.10.0",\n  "private": true')
  expect(JSON.parse(after.get('package-lock.json')!)).toEqual({
    version: '0.10.0',
    packages: {
      '': { version: '0.10.0' },
      'packages/lab': { version: '0.10.0' },
      'node_modules/idb': { version: '0.9.3' },
      'apps/cli/node_modules/ajv': { version: '0.9.3' },
    },
  })
  expect(after.get('CHANGELOG.md')).toBe(
    '# Changelog\n\n## [Unreleased]\n\n## [0.10.0] - 2026-12-24\n\n### Added\n\n- A bell.\n\n## [0.9.3] - 2026-11-22\n',
  )
})

test.each(['0.9.3', '0.9.2', '0.8.9', '0.0.9', '', 'v1.0.0', '1.0', '1.0.0-beta', '1.0.0.0', 'newest'])(
  'the version %j is refused: it is none, or not newer than 0.9.3',
  (version) => {
    expect(() => released(files, version, '2026-12-24')).toThrow(Trouble)
    expect(() => released(files, version, '2026-12-24')).toThrow('a newer one such as 0.10.0')
  },
)

test('of any two versions exactly the greater one is newer', () => {
  const part = fc.nat(12)
  fc.assert(
    fc.property(fc.tuple(part, part, part), fc.tuple(part, part, part), (a, b) => {
      const at = new Map(files).set('package.json', JSON.stringify({ version: a.join('.') }))
      const value = (all: readonly number[]) => all.reduce((sum, one) => sum * 100 + one, 0)
      const act = () => released(at, b.join('.'), '2026-12-24')
      if (value(b) > value(a)) expect(act().size).toBe(files.size)
      else expect(act).toThrow(Trouble)
    }),
  )
})

test('without anything new there is no release', () => {
  const empty = new Map(files).set(
    'CHANGELOG.md',
    '# Changelog\n\n## [Unreleased]\n\n## [0.9.3] - 2026-11-22\n',
  )
  expect(() => released(empty, '1.0.0', '2026-12-24')).toThrow('nothing under "Unreleased"')
})
