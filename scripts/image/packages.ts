/** Names in a list of packages: one a line, with what stands behind `#` left out. @throws at a line that is no name */
export function packagesIn(text: string): readonly string[] {
  return text
    .split('\n')
    .map((line) => line.replace(/#.*/, '').trim())
    .filter((name) => name !== '')
    .map((name) => {
      if (!/^[a-z0-9][a-z0-9+.-]+$/.test(name)) throw new Error(`No name of a package: ${name}`)
      return name
    })
}
