import type { MapStation } from '@botgarten/programs'
import type { Point } from '../point.ts'
import type { StationLabel } from './labels.ts'

export const ink = '#4A3428'
/** Height of the numbers of stations; names follow when they are enlarged. */
export const NUMBERS = 44

/** To a tenth of a unit. */
export const round = (value: number) => Number(value.toFixed(1))

/** A group of the drawing by its name. */
export const layer = (id: string, content: readonly string[], more = '') =>
  `<g id="${id}"${more && ` ${more}`}>\n${content.filter(Boolean).join('\n')}\n</g>`

const escapes: { readonly [sign: string]: string } = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }
const escaped = (text: string) =>
  text.replace(/[&<>"]/g, (sign) => escapes[sign]!).replace(/[\n\r\t]/g, (sign) => `&#${sign.charCodeAt(0)};`)

/** `data-…` of what is there. */
export function attributes(of: { readonly [name: string]: string | number | undefined }): string {
  const said = Object.entries(of).filter(([, value]) => value !== undefined)
  return said.map(([name, value]) => ` data-${name}="${escaped(String(value))}"`).join('')
}

/** What is paid there. */
export const coinAt = ({ x, y }: Point, reward: number) =>
  `<g transform="translate(${round(x)} ${round(y)})"><circle r="30" fill="${reward > 0 ? '#FFC83D' : '#FBE1DA'}" stroke="${ink}" stroke-width="5"/><text y="9" text-anchor="middle" font-family="'Baloo 2', Nunito, sans-serif" font-weight="800" font-size="26" fill="#3A2A20" stroke="none">${reward > 0 ? '+' : '−'}${Math.abs(reward)}</text></g>`

/** A station; its looks change by these classes while the robot learns. */
export function stationDrawn(
  { x, y, name, reward }: MapStation,
  number: number,
  { radius = 44, label = null }: { readonly radius?: number; readonly label?: StationLabel | null } = {},
): string {
  const coin = reward ? coinAt({ x: -46, y: 46 }, reward) : ''
  return [
    `<g id="node-${number}" class="station" transform="translate(${x} ${y})"${attributes({ name, reward })}>`,
    `<circle class="shade" cy="${round(radius / 9)}" r="${radius}" fill="#3A2A20" fill-opacity=".25"/>`,
    `<circle class="disc" r="${radius}" fill="#C23A30" stroke="${ink}" stroke-width="6"/>`,
    `<circle class="ring" r="${round(radius * 0.8)}" fill="none" stroke="#FFFFFF" stroke-width="4" stroke-dasharray="10 8"/>`,
    `<text class="number" y="${round(radius * 0.34)}" fill="#FFFFFF">${number}</text>${label ? labelDrawn(label) : ''}${coin}</g>`,
  ].join('')
}

const labelDrawn = ({ text, x, y, size }: StationLabel) =>
  `<text class="name" x="${round(x)}" y="${round(y + size * 0.35)}" font-size="${(size / NUMBERS).toFixed(2)}em" stroke="#FFFDF8" stroke-width="9" paint-order="stroke">${escaped(text)}</text>`
