const query = globalThis.matchMedia?.('(prefers-reduced-motion: reduce)')
let reduced = $state(query?.matches ?? false)
query?.addEventListener('change', () => (reduced = query.matches))

/** Does this device ask for less motion? */
export const reducedMotion = () => reduced
