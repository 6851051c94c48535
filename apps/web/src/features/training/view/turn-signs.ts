import type { Turn } from '../model/table.ts'

/** Of each way: the colour of its dot and of its sea, and an arrow in a box of 20. */
export const signs: {
  readonly [turn in Turn]: { readonly colour: string; readonly sea: string; readonly path: string }
} = {
  straight: { colour: '#6B5545', sea: '#F1E8DB', path: 'M0 6V-6M-4 -2L0 -6L4 -2' },
  left: { colour: '#6F55C4', sea: '#D9CFF1', path: 'M4 6V2Q4 -2 0 -2H-5M-2 -6L-6 -2L-2 2' },
  right: { colour: '#B25A00', sea: '#F8D2AC', path: 'M-4 6V2Q-4 -2 0 -2H5M2 -6L6 -2L2 2' },
  back: { colour: '#0B7C88', sea: '#CFE6E8', path: 'M0 -6V6M-4 2L0 6L4 2' },
  stand: { colour: '#4A3428', sea: '#DCC7A5', path: 'M-4 -4H4V4H-4Z' },
}
