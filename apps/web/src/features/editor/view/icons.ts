import * as Blockly from 'blockly/core'
import type { Look } from '@botgarten/blocks'

type IconName = NonNullable<Look['icon']>

const line = 'fill="none" stroke="#fff" stroke-width="2.2" stroke-linecap="round" stroke-linejoin="round"'
const drawings: { readonly [icon in IconName]: string } = {
  play: '<path fill="#fff" d="M8 5.2v13.6c0 .8.9 1.3 1.6.8l10-6.8c.6-.4.6-1.2 0-1.6l-10-6.8C8.9 3.9 8 4.4 8 5.2z"/>',
  network: `<g ${line}><circle cx="5" cy="6.5" r="2.5"/><circle cx="5" cy="17.5" r="2.5"/><circle cx="19" cy="12" r="2.5"/><path d="M7.4 7.5l9.2 3.6M7.4 16.5l9.2-3.6"/></g>`,
  map: `<g ${line}><path d="M3 6.5l6-2.5 6 2.5 6-2.5v13.5l-6 2.5-6-2.5-6 2.5z"/><path d="M9 4v13.5M15 6.5V20"/></g>`,
  gear: `<g ${line}><path d="M4 7h9M17 7h3M4 17h3M11 17h9"/><circle cx="15" cy="7" r="2"/><circle cx="9" cy="17" r="2"/></g>`,
  repeat: `<g ${line}><path d="M4.5 12a7.5 7.5 0 1 0 2.6-5.7"/><path d="M4 3.5l2.8 3.1 3.7-1.7"/></g>`,
}
const sizes: { readonly [icon in IconName]: number } = {
  play: 30,
  network: 28,
  repeat: 24,
  map: 26,
  gear: 26,
}

/** The little drawing on a block. The words beside it say the same, so that readers skip it. */
export function iconField(name: IconName): Blockly.FieldImage {
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">${drawings[name]}</svg>`
  const size = sizes[name]
  const field = new Blockly.FieldImage(`data:image/svg+xml,${encodeURIComponent(svg)}`, size, size)
  field.computeAriaLabel = () => ''
  return field
}
