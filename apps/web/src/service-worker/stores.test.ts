import { expect, test } from 'vitest'
import { isPast, storeOf } from './stores.ts'

const all = ['botgarten-100', 'botgarten-200', 'botgarten-300', 'somebody-elses']
const past = (names: readonly string[], version: string) =>
  names.filter((name) => isPast(name, names, version))

test('the version before stays for pages that are still open, what is older goes', () =>
  expect(past(all, '300')).toEqual(['botgarten-100']))

test('a first version forgets nothing, and never what is not ours', () => {
  expect(past([storeOf('300')], '300')).toEqual([])
  expect(past(['somebody-elses', 'botgarten-300'], '300')).toEqual([])
})
