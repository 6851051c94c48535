import self from './package.json' with { type: 'json' }

/** Botgarten's version. `npm run release` sets it in every package; the one in the root's package.json counts. */
export const { version } = self
