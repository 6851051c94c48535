/** Is this `npm run test:long`? */
export const isLong = process.env['BOTGARTEN_LONG'] === '1'

/** The cases that tests go through: all of them in `npm run test:long`, the first `few` in `npm test`. */
export const sample = <Case>(all: readonly Case[], few: number): readonly Case[] =>
  isLong ? all : all.slice(0, few)
