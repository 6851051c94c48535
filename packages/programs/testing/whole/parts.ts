import type { Block } from '@botgarten/blocks'

export const fieldOf = (block: Block, name: string): string => block.fields?.[name] ?? ''
export const between = (x: number, low: number, high: number) => Math.min(Math.max(x, low), high) + 0
export const percent = (x: number) => between(x, -100, 100)
