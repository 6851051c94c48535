import type { Flow } from './flow.ts'

const middle = { x: 325, width: 326 }
const half = { width: 240 }

/** One round of Q-learning as a child does it with a dice: what `packages/learning/q-learning/model.md` calls a move. */
export const qLearning: Flow = {
  width: 650,
  row: 78,
  boxes: [
    { id: 'start', look: 'end', picture: 'bo', row: 0, ...middle },
    { id: 'where', look: 'step', number: 1, row: 1, ...middle },
    { id: 'jump', look: 'question', number: 2, row: 2, ...middle, width: 286 },
    { id: 'place', look: 'step', row: 2, x: 560, width: 110 },
    { id: 'dice', look: 'question', number: 3, picture: 'dice', row: 3, ...middle },
    { id: 'new', look: 'step', row: 4, ...half, x: 195 },
    { id: 'best', look: 'step', row: 4, ...half, x: 455 },
    { id: 'go', look: 'step', number: 4, row: 5, ...middle },
    { id: 'reward', look: 'step', number: 5, picture: 'coin', row: 6, ...middle },
    { id: 'write', look: 'step', number: 6, picture: 'pencil', row: 7, ...middle },
    { id: 'over', look: 'question', row: 8, ...middle },
  ],
  ways: [
    { from: 'start', to: 'where' },
    { from: 'where', to: 'jump' },
    { from: 'jump', to: 'place', out: 'right', into: 'left', word: 'yes' },
    { from: 'jump', to: 'dice', word: 'no' },
    { from: 'place', to: 'dice' },
    { from: 'dice', to: 'new' },
    { from: 'dice', to: 'best' },
    { from: 'new', to: 'go' },
    { from: 'best', to: 'go' },
    { from: 'go', to: 'reward' },
    { from: 'reward', to: 'write' },
    { from: 'write', to: 'over' },
    { from: 'over', to: 'where', out: 'left', into: 'left', lane: 34, word: 'no', then: 'nextMove' },
    { from: 'over', to: 'start', out: 'right', into: 'right', lane: 632, word: 'yes', then: 'nextTry' },
  ],
}

/** Flow diagrams by the id that a text names. */
export const flows = { 'q-learning': qLearning } as const satisfies { readonly [id: string]: Flow }
