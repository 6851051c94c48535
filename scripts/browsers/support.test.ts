import { describe, expect, test } from 'vitest'
import { promised } from '../../packages/browsers/promised.ts'
import { entryAt, missingIn, newerNames, versionsOf } from './support.mjs'

const missing = (path: string) =>
  missingIn(entryAt(path)!, promised).map(({ browser, since }) => `${browser} ${since}`)

describe('versions of the table', () => {
  test('an API that is newer than the promise is missing where it is newer', () => {
    expect(missing('javascript.builtins.Map.groupBy')).toEqual([
      'safari 17.4',
      'safari_ios 17.4',
      'firefox 119',
      'chrome 117',
      'edge 117',
    ])
    expect(missing('api.URL.canParse_static')).toEqual([
      'safari 17',
      'safari_ios 17',
      'chrome 120',
      'edge 120',
    ])
    expect(missing('css.selectors.has')).toEqual(['firefox 121'])
  })

  test('an API that is as old as the promise is there', () => {
    // New in Firefox 115 and Safari 16.
    expect(missing('javascript.builtins.Array.toSorted')).toEqual([])
    expect(versionsOf(entryAt('javascript.builtins.Array.toSorted')!)).toEqual(['16', '115', '110'])
  })

  test('an API that a browser has behind a setting, with a prefix or under another name is missing', () => {
    const entry = (support: object) => ({ __compat: { support: { firefox: support } } })
    const lacks = (support: object) => missingIn(entry(support), { firefox: '115' }).length
    expect(lacks({ version_added: '100' })).toBe(0)
    expect(lacks({ version_added: '100', flags: [{ name: 'x' }] })).toBe(1)
    expect(lacks({ version_added: '100', prefix: '-moz-' })).toBe(1)
    expect(lacks({ version_added: '100', alternative_name: 'old' })).toBe(1)
    expect(lacks({ version_added: 'preview' })).toBe(1)
    expect(lacks({ version_added: false })).toBe(1)
    expect(lacks([{ version_added: '120' }, { version_added: '100', prefix: '-moz-' }])).toBe(1)
  })

  test('what was there with a note before counts from then on, what was removed does not', () => {
    const lacks = (support: object) =>
      missingIn({ __compat: { support: { chrome: support } } }, { chrome: '111' }).length
    expect(
      lacks([{ version_added: '124' }, { version_added: '103', version_removed: '124', notes: '' }]),
    ).toBe(0)
    expect(lacks([{ version_added: '124' }, { version_added: '60', version_removed: '100' }])).toBe(1)
    expect(lacks({ version_added: '60', version_removed: '100' })).toBe(1)
  })

  test('a path without an entry is null', () => {
    expect([entryAt('api.URL.unheard'), entryAt('api.toString')]).toEqual([null, null])
  })
})

test('lint refuses static members and global names that a promised browser lacks, and no others', () => {
  const { properties, globals } = newerNames(promised)
  const names = properties.map(({ object, property }) => `${object}.${property}`)
  expect(names).toEqual(expect.arrayContaining(['Map.groupBy', 'URL.parse', 'URL.canParse', 'Promise.withResolvers', 'Intl.Segmenter'])) // prettier-ignore
  expect(names).not.toContain('URL.createObjectURL')
  expect(globals).toContain('Translator')
  expect(globals).not.toContain('URL')
})
