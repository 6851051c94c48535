import { expect, test } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { drawFaults, faultsOf } from './views.ts'

const changesIn = (source: string) => faultsOf('A.svelte', source).map(({ kind, change }) => [kind, change])

test.each([
  ['{#if a}x{/if}', [['condition', 'a → !(a)']]],
  ['{#if a === { b }.b}x{:else if c}y{/if}', [['condition', 'a === { b }.b → !(a === { b }.b)'], ['condition', 'c → !(c)']]], // prettier-ignore
  ['<Button onclick={() => { a() }} label={b} />', [['handler', 'onclick={() => { a() }} → nothing'], ['property', 'label={b} → nothing']]], // prettier-ignore
  ['<p>{a ? b : c}</p>', [['value', '? b : c → ? c : b']]],
])('%s has these faults', (source, changes) => {
  expect(changesIn(source)).toEqual(changes)
})

test.each([
  '<script lang="ts">const a = b ? 1 : 2; f({ onclick: a })</script>',
  '<!-- {#if a} --><p class={a} style:top={b}></p>',
  '<Icon name="check" size={20} still={true} />',
])('%s has none: it is a script, a comment or a look', (source) => {
  expect(changesIn(source)).toEqual([])
})

test('a fault changes its own place and nothing else', () => {
  const [fault] = faultsOf('A.svelte', '<p>one</p>\n<button onclick={a}>two</button>\n')
  expect(fault).toMatchObject({ line: 2, text: '<p>one</p>\n<button >two</button>\n' })
})

test('the same seed draws the same faults, each in another feature; another seed draws others', () => {
  const drawn = (seed: number) => drawFaults(inHouse('.'), { count: 10, seed })
  const features = drawn(1).map(({ file }) => file.split('/')[4])
  expect(new Set(features).size).toBe(10)
  expect(drawn(1)).toEqual(drawn(1))
  expect(drawn(2).map(({ file }) => file)).not.toEqual(drawn(1).map(({ file }) => file))
})
