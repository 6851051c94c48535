import { render } from 'svelte/server'
import { expect, test } from 'vitest'
import type { Command } from '#drawing/commands.ts'
import Drawing from './Drawing.svelte'

const svg = (shapes: readonly Command[]) =>
  render(Drawing, { props: { shapes } }).body.replaceAll(/<!--.*?-->/g, '')

test('shapes become the elements of SVG with their ink', () => {
  expect(svg([{ kind: 'path', d: 'M0 0h1', stroke: '#000', lineWidth: 2, dash: [2, 8] }])).toBe(
    '<path d="M0 0h1" fill="none" stroke="#000" stroke-width="2" stroke-dasharray="2 8" stroke-linecap="round" stroke-linejoin="round"></path>',
  )
  expect(svg([{ kind: 'circle', x: 1, y: 2, r: 3, fill: 'red' }])).toBe(
    '<ellipse cx="1" cy="2" rx="3" ry="3" fill="red"></ellipse>',
  )
})

test('many lines at once are one path', () => {
  const points = new Float32Array([0, 0, 1, 2, NaN, NaN, 3, 4, 5, 6])
  expect(svg([{ kind: 'lines', points, stroke: '#000' }])).toContain('d="M0 0L1 2M3 4L5 6"')
})

test('a group is moved, then turned, then scaled', () => {
  expect(svg([{ kind: 'group', x: 5, y: 6, turn: 90, scale: [2, 3], shapes: [] }])).toBe(
    '<g transform="translate(5 6) rotate(90) scale(2 3)"></g>',
  )
})

test('letters that come from a child stay letters', () => {
  expect(svg([{ kind: 'text', text: '<b>', x: 0, y: 0, size: 10, font: 'read' }])).toContain('&lt;b></text>')
})
