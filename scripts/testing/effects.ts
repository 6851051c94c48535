import type { Environment } from 'vitest/runtime'

/** Node, with the modules of Svelte that run effects. */
export default {
  name: 'effects',
  viteEnvironment: 'client',
  setup: () => ({ teardown() {} }),
} satisfies Environment
