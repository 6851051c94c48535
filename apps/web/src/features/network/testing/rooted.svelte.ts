/** Makes something whose effects run until `stop`, as in a component. */
export function rooted<Made>(make: () => Made): { readonly made: Made; readonly stop: () => void } {
  let made: Made
  const stop = $effect.root(() => {
    made = make()
  })
  return { made: made!, stop }
}
