// A picture is enlarged by a click, and by another one small again.
document.addEventListener('click', ({ target }) => {
  if (target.matches('.md-content img')) target.classList.toggle('large');
});
document.addEventListener('keydown', ({ key }) => {
  if (key === 'Escape') document.querySelectorAll('img.large').forEach((image) => image.classList.remove('large'));
});
// Formulas, as the Markdown extension has marked them.
document.querySelectorAll('.arithmatex').forEach((formula) => window.renderMathInElement(formula, {
  delimiters: [{ left: '\\(', right: '\\)', display: false }, { left: '\\[', right: '\\]', display: true }],
}));
