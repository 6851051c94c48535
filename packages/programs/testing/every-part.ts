import type { Project } from '../index.ts'

/** The name of its picture. */
export const sha256 = '0'.repeat(64)

/** A project with every part that one can have. */
export const project: Project = {
  botgarten: 1,
  name: 'Freundschaft',
  card: 'friendship',
  programs: {
    main: {
      stacks: [
        {
          x: 20,
          y: 24.5,
          blocks: [
            {
              id: 'a',
              type: 'robControls_start',
              fields: { DEBUG: 'FALSE' },
              mutation: { attrs: { declare: 'false' } },
            },
            {
              id: 'b',
              type: 'robActions_somethingNew',
              values: { X: { id: 'c', type: 'math_number', fields: { NUM: '1' } } },
            },
          ],
        },
      ],
      config: { stacks: [] },
    },
  },
  world: {
    size: { width: 200, height: 150 },
    floor: { asset: 'content:worlds/friendship/floor.png' },
    areas: [
      {
        id: 'area',
        shape: { kind: 'circle', radius: 5 },
        pose: { x: 1, y: 2, heading: 3 },
        colour: '#00642E',
      },
    ],
    lines: [
      {
        id: 'line',
        points: [
          { x: 0, y: 0 },
          { x: 10, y: 10 },
        ],
        width: 2,
        colour: '#000000',
      },
    ],
    obstacles: [
      {
        id: 'square',
        shape: { kind: 'rectangle', width: 40, height: 40 },
        pose: { x: 100, y: 100, heading: 0 },
        fixed: true,
        colour: '#0057A6',
        look: 'crate',
      },
    ],
    robots: [
      {
        id: 'bo',
        pose: { x: 50, y: 50, heading: 90 },
        program: 'main',
        brain: '',
        config: {
          wheelDiameter: 5.6,
          trackWidth: 18,
          sensors: {
            1: { kind: 'colour', x: 9, y: 0, angle: 0 },
            2: { kind: 'ultrasonic', x: 10, y: 5, angle: 20 },
            4: { kind: 'position', x: 0, y: 0, angle: 0 },
          },
          drive: { left: 'C', right: 'B' },
          noise: 5,
          delay: 12,
          strength: { left: 0.8, right: 1 },
        },
      },
    ],
  },
  brains: {
    net: {
      kind: 'network',
      layers: [
        [{ id: 'in', activation: 'identity', bias: 0 }],
        [{ id: 'out', activation: 'identity', bias: 0 }],
      ],
      weights: { in: { out: 0.8 } },
      sets: { fear: { in: { out: -0.8 } } },
    },
  },
  sorting: { version: 1, source: 'points', rows: [[1, 2.5]], names: ['Äpfel'] },
  assets: { [sha256]: { type: 'image/png', base64: 'iVBORw0KGgo=' } },
  progress: { starts: [0, 2], hints: 1 },
  shelf: 'all',
  madeFrom: [{ id: 'shared-1', title: 'Rally, schnell' }],
}
