/** A file that holds a program, by its name: the page opens it wherever it is let go. */
export const isProgramFile = (name: string): boolean => /\.(xml|botgarten|botgarten\.json)$/i.test(name)

/** Is this a file of Open Roberta, by its name or by how it begins? */
export const isOpenRoberta = (name: string, text: string): boolean =>
  /\.xml$/i.test(name) || /^\uFEFF?\s*(<\?xml[^>]*>\s*)?<(\w+:)?export[\s>]/.test(text.slice(0, 1000))
