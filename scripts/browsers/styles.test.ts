import { expect, test } from 'vitest'
import { promised } from '../../packages/browsers/promised.ts'
import { reportOf } from './report.ts'
import { stylesIn } from './styles.ts'

const none = { handled: {}, faults: {} }
const lackingIn = (text: string, file = 'a.css') =>
  reportOf(stylesIn([{ file, text }]), promised, none).lacking.map(
    ({ name, missing }) => `${name}: ${missing}`,
  )

test.each([
  ['a:has(b) { color: red }', ':has: firefox before 121'],
  ['a { zoom: 2 }', 'zoom: firefox before 126'],
  [
    'a { grid-template-columns: subgrid }',
    'grid-template-columns: subgrid: chrome before 117, edge before 117',
  ],
  ['@page { margin: 0 }', '@page: safari before 18.2, safari_ios before 18.2'],
])('%s is newer than promised', (css, missing) => {
  expect(lackingIn(css)).toContain(missing)
})

test.each([
  'a { color: color-mix(in srgb, red, blue) }',
  // The build writes these names with their prefix.
  'a { user-select: none; print-color-adjust: exact }',
  'a { --own: subgrid }',
  '.has, #zoom { inset: 0 }',
  '@container (min-width: 1px) { a { width: 1cqw } }',
])('%s is not', (css) => {
  expect(lackingIn(css)).toEqual([])
})

test('of a component its styles are read, and not its script', () => {
  const component = '<script>const zoom = ":has"</script>\n<p>zoom: 2</p>\n<style>\n  p { zoom: 2 }\n</style>'
  expect(lackingIn(component, 'a.svelte')).toEqual(['zoom: firefox before 126'])
  expect(lackingIn('<p>zoom</p>', 'a.svelte')).toEqual([])
})
