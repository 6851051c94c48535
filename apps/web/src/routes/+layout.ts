// The lab lives in the browser; pages are shells that start with the network cable pulled.
export const ssr = false
export const prerender = true
