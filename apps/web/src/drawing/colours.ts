import { clamp } from './points.ts'

const channels = (colour: string): readonly [number, number, number] => {
  const value = Number.parseInt(colour.slice(1), 16)
  return [(value >> 16) & 255, (value >> 8) & 255, value & 255]
}

const hex = (part: number) => Math.round(part).toString(16).padStart(2, '0')

/** `#RRGGBB` mixed with another; `share` 0..1 of the other. */
export function mix(colour: string, other: string, share: number): string {
  const a = channels(colour)
  const b = channels(other)
  return `#${a.map((part, i) => hex(part + (b[i]! - part) * share)).join('')}`.toUpperCase()
}

/** The grey that is as bright (CSS Filter Effects, `grayscale`). @param colour `#RGB` or `#RRGGBB` */
export function greyOf(colour: string): string {
  const full = colour.length === 4 ? colour.replace(/[^#]/g, '$&$&') : colour
  const [r, g, b] = channels(full)
  const part = hex(0.2126 * r + 0.7152 * g + 0.0722 * b)
  return `#${part}${part}${part}`
}

/** Is a ring of this colour hard to see on paper? (WCAG relative luminance over one half) */
export function isPale(colour: string): boolean {
  const [r, g, b] = channels(colour).map((part) => {
    const share = part / 255
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4
  }) as [number, number, number]
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.5
}

const POSITIVE = ['#FFF6D8', '#F5C64A', '#6DBE76'] as const
const NEGATIVE = ['#FFF6D8', '#C3D0D8', '#8DA1B0'] as const

/**
 * Colour of a value 0..100: pale, gold, green; the higher the darker, so that it can be read in grey, and always with its
 * number. Below 0 blue-grey. @returns `#RRGGBB`
 */
export function heatOf(value: number): string {
  const scale = value < 0 ? NEGATIVE : POSITIVE
  const share = clamp(Math.abs(value) / 100, 0, 1) * 2
  return share <= 1 ? mix(scale[0], scale[1], share) : mix(scale[1], scale[2], share - 1)
}
