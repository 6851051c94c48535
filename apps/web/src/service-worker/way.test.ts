import { expect, test } from 'vitest'
import { isPast, oneOf, storeOf, wayOf } from './way.ts'

const scope = 'https://school.example/bot/'
const own = {
  scope,
  pages: new Set([scope, `${scope}lab/fear`, `${scope}about/`]),
  files: new Set([`${scope}_app/immutable/a.js`, `${scope}operator.md`]),
}
const way = (path: string, mode = 'navigate', method = 'GET') =>
  wayOf({ url: new URL(path, scope).href, mode, method }, own)

test('parts and pages of this version are kept ones, whatever they are asked with', () => {
  expect(way('_app/immutable/a.js', 'cors')).toEqual({ kind: 'kept', address: `${scope}_app/immutable/a.js` })
  expect(way('lab/fear?p=fear-1x&start#there')).toEqual({ kind: 'kept', address: `${scope}lab/fear` })
  expect(way('./')).toEqual({ kind: 'kept', address: scope })
})

test('a page is found with and without a slash at its end', () => {
  expect(way('lab/fear/')).toEqual({ kind: 'moved', address: `${scope}lab/fear` })
  expect(way('about?a=1#there')).toEqual({ kind: 'moved', address: `${scope}about/?a=1` })
})

test('one page is kept for all cards', () => {
  const pages = new Set([scope, `${scope}lab/free`, `${scope}lab/fear`])
  expect(oneOf(`${scope}lab/fear`, { scope, pages })).toBe(`${scope}lab/free`)
  expect(oneOf(scope, { scope, pages })).toBe(scope)
  const asked = { url: `${scope}lab/fear?p=1`, mode: 'navigate', method: 'GET' }
  expect(wayOf(asked, { ...own, pages })).toEqual({ kind: 'kept', address: `${scope}lab/free` })
  expect(wayOf({ ...asked, url: `${scope}lab/nosuchcard` }, { ...own, pages }).kind).toBe('home')
})

test('one page is kept for all learning materials, beside the library', () => {
  const library = `${scope}materials/`
  const [plan, sheet] = [`${library}curriculum/plan`, `${library}sheet/flow`]
  const pages = new Set([library, plan, sheet])
  expect([library, plan, sheet].map((page) => oneOf(page, { scope, pages }))).toEqual([library, plan, plan])
})

test('what the operator writes is asked for again', () =>
  expect(way('operator.md', 'cors').kind).toBe('newest'))

test('an address that is no page leads home where there is no server', () =>
  expect(way('lab/nosuchcard').kind).toBe('home'))

test('what is no part of the product is left alone', () => {
  expect(way('https://other.example/bot/', 'navigate').kind).toBe('server')
  expect(way('https://school.example/wiki').kind).toBe('server')
  expect(way('lab/fear', 'navigate', 'POST').kind).toBe('server')
  expect(way('nosuchfile.js', 'cors').kind).toBe('server')
})

const all = ['botgarten-100', 'botgarten-200', 'botgarten-300', 'somebody-elses']
const past = (names: readonly string[], version: string) =>
  names.filter((name) => isPast(name, names, version))

test('the version before stays for pages that are still open, what is older goes', () =>
  expect(past(all, '300')).toEqual(['botgarten-100']))

test('a first version forgets nothing, and never what is not ours', () => {
  expect(past([storeOf('300')], '300')).toEqual([])
  expect(past(['somebody-elses', 'botgarten-300'], '300')).toEqual([])
})
